/** The pointer over the maze: edits with the chosen tool, or draws the tape of the Measure tool. */
import type { Cell } from "@corridor/maze";
import type { Services } from "../../model/services.ts";
import { cellAt } from "../../stage/drawing/viewport.ts";
import { isInPort } from "../../stage/page/grid-place.ts";
import type { PointerDetails, PointerInput } from "../../stage/page/pointer-input.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { tapePointAt, type TapePoint } from "../../stage/page/tape.ts";
import type { MeasureTool } from "./measure-tool.ts";

export interface StagePointerPorts {
  services: Pick<Services, "screen" | "camera">;
  view: StageViewStore;
  /** scrolls if the maze is larger than the view */
  scroller: HTMLElement;
  /** lies over the maze and receives the pointer */
  grid: HTMLElement;
  /** receives the pointer unless the user measures */
  input: PointerInput;
  measure: MeasureTool;
}

type PointerEventName =
  | "pointerdown"
  | "pointermove"
  | "pointerup"
  | "pointercancel"
  | "pointerleave";

/** @returns a function that removes the listeners */
export function listenToPointer(ports: StagePointerPorts): () => void {
  const { services, grid, input, measure } = ports;
  const { screen, camera } = services;
  const end = new AbortController();
  const on = (type: PointerEventName, handle: (event: PointerEvent) => void): void =>
    grid.addEventListener(
      type,
      (event) => {
        // In the Drive tab the pointer does not edit, because the tools are hidden.
        if (!camera.getState().isDriving) handle(event);
      },
      { signal: end.signal },
    );
  const isMeasuring = (): boolean => screen.getState().tool === "measure";
  on("pointerdown", (event) => {
    // A drag that leaves the maze still ends here.
    grid.setPointerCapture(event.pointerId);
    if (!isMeasuring()) return input.down(detailsOf(ports, event));
    const point = pointUnder(ports, event);
    if (event.isPrimary && event.button === 0 && point !== null) {
      measure.begin(event.pointerId, point);
    }
  });
  on("pointermove", (event) => {
    if (!isMeasuring()) return input.move(detailsOf(ports, event));
    const point = pointUnder(ports, event);
    if (point !== null) measure.drag(event.pointerId, point);
  });
  on("pointerup", (event) => {
    if (!isMeasuring()) return input.up(detailsOf(ports, event));
    measure.end(event.pointerId);
  });
  on("pointercancel", () => {
    if (isMeasuring()) measure.clear();
    else input.cancel();
  });
  on("pointerleave", () => input.leave());
  return () => end.abort();
}

function detailsOf(ports: StagePointerPorts, event: PointerEvent): PointerDetails {
  const { pointerId, pointerType, button, isPrimary } = event;
  return { pointerId, pointerType, button, isPrimary, cell: cellUnder(ports, event) };
}

function cellUnder({ view, scroller, grid }: StagePointerPorts, event: PointerEvent): Cell | null {
  const { layout } = view.getState();
  if (layout === null) return null;
  const room = scroller.getBoundingClientRect();
  if (!isInPort(layout, event.clientX - room.left, event.clientY - room.top)) return null;
  const maze = grid.getBoundingClientRect();
  return cellAt(layout, event.clientX - maze.left, event.clientY - maze.top);
}

function pointUnder({ view, grid }: StagePointerPorts, event: PointerEvent): TapePoint | null {
  const { layout } = view.getState();
  if (layout === null) return null;
  const maze = grid.getBoundingClientRect();
  return tapePointAt(layout, event.clientX - maze.left, event.clientY - maze.top);
}
