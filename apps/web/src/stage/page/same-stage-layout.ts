/** Equality of layouts, which are computed anew whenever something that they depend on may change. */
import type { Layout, Scroll } from "../drawing/viewport.ts";

export function isSameStageLayout(one: Layout, other: Layout): boolean {
  return (
    one.columns === other.columns &&
    one.rows === other.rows &&
    one.cellPx === other.cellPx &&
    isSameSize(one.view, other.view) &&
    isSameSize(one.content, other.content) &&
    isSamePoint(one.origin, other.origin) &&
    isSamePoint(one.port, other.port) &&
    isSameSize(one.port, other.port) &&
    one.overflows === other.overflows &&
    one.follows === other.follows
  );
}

type Size = Pick<Layout["port"], "width" | "height">;

const isSameSize = (one: Size, other: Size): boolean =>
  one.width === other.width && one.height === other.height;

const isSamePoint = (one: Scroll, other: Scroll): boolean => one.x === other.x && one.y === other.y;
