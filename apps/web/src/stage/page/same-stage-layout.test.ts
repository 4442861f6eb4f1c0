import { describe, expect, it } from "vitest";
import type { Layout } from "../drawing/viewport.ts";
import { isSameStageLayout } from "./same-stage-layout.ts";
import { stageLayout } from "./stage-layout.ts";

const layout = stageLayout({ columns: 11, rows: 7 }, { width: 1028, height: 644 }, true);

describe("equal layouts", () => {
  it("are equal after they were computed again", () => {
    expect(isSameStageLayout(layout, structuredClone(layout))).toBe(true);
  });

  it.each<Partial<Layout>>([
    { columns: 12 },
    { rows: 8 },
    { cellPx: 1 },
    { view: { ...layout.view, width: 1 } },
    { view: { ...layout.view, height: 1 } },
    { content: { ...layout.content, width: 1 } },
    { content: { ...layout.content, height: 1 } },
    { origin: { ...layout.origin, x: 1 } },
    { origin: { ...layout.origin, y: 1 } },
    { port: { ...layout.port, x: 1 } },
    { port: { ...layout.port, y: 1 } },
    { port: { ...layout.port, width: 1 } },
    { port: { ...layout.port, height: 1 } },
    { overflows: true },
    { follows: true },
  ])("differ in %o", (change) => {
    expect(isSameStageLayout(layout, { ...layout, ...change })).toBe(false);
    expect(isSameStageLayout({ ...layout, ...change }, layout)).toBe(false);
  });
});
