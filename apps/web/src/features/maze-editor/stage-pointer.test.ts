import { describe, expect, it } from "vitest";
import { createCameraStore } from "../../model/screen/camera-store.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { layOut } from "../../stage/drawing/viewport.ts";
import { PointerInput, type Intent } from "../../stage/page/pointer-input.ts";
import { createStageView } from "../../stage/page/stage-view.ts";
import { MeasureTool } from "./measure-tool.ts";
import { listenToPointer } from "./stage-pointer.ts";

/** An element at a place of the window. */
class PlacedElement extends EventTarget {
  readonly left: number;
  readonly top: number;
  captured: number | null = null;

  constructor(left: number, top: number) {
    super();
    this.left = left;
    this.top = top;
  }

  getBoundingClientRect() {
    return { left: this.left, top: this.top };
  }

  setPointerCapture(pointerId: number): void {
    this.captured = pointerId;
  }
}

/** A maze of 4 by 3 squares of 100 px, 10 px from the corner of the stage at (200, 100). */
function open() {
  const padding = { top: 10, right: 10, bottom: 10, left: 10 };
  const layout = layOut({ columns: 4, rows: 3 }, { width: 420, height: 320 }, padding, 30);
  const view = createStageView();
  view.setState({ layout });
  const grid = new PlacedElement(210, 110);
  const camera = createCameraStore();
  const screen = createScreenStore();
  const intents: Intent[] = [];
  const stop = listenToPointer({
    services: { camera, screen },
    view,
    scroller: new PlacedElement(200, 100) as unknown as HTMLElement,
    grid: grid as unknown as HTMLElement,
    input: new PointerInput((intent) => intents.push(intent)),
    measure: new MeasureTool(view),
  });
  const fire = (type: string, clientX = 0, clientY = 0): void => {
    const event = new Event(`pointer${type}`);
    const pointer = { pointerId: 7, pointerType: "mouse", button: 0, isPrimary: true };
    grid.dispatchEvent(Object.assign(event, pointer, { clientX, clientY }));
  };
  return { view, grid, camera, screen, intents, stop, fire };
}

describe("the pointer over the maze", () => {
  it("edits the squares from where it went down to where it is", () => {
    const { grid, intents, fire } = open();
    fire("down", 215, 115);
    fire("move", 315, 115);
    fire("up", 315, 115);
    expect(intents).toEqual([
      { type: "hover", cell: null },
      { type: "begin", cell: { column: 0, row: 0 } },
      { type: "paint", cells: [{ column: 1, row: 0 }] },
      { type: "end" },
      { type: "hover", cell: { column: 1, row: 0 } },
    ]);
    expect(grid.captured).toBe(7);
  });

  it("is over no square in the margin of the stage", () => {
    const { intents, fire } = open();
    fire("move", 205, 115);
    expect(intents).toEqual([{ type: "hover", cell: null }]);
  });

  it("draws a tape with the Measure tool, and edits nothing", () => {
    const { view, screen, intents, fire } = open();
    screen.setState({ tool: "measure" });
    fire("down", 260, 160);
    fire("move", 360, 160);
    fire("up");
    const tape = { from: { x: 50, y: 50 }, to: { x: 150, y: 50 }, isOpen: false };
    expect(view.getState().tape).toEqual(tape);
    fire("cancel");
    expect(view.getState().tape).toBeNull();
    expect(intents).toEqual([]);
  });

  it("reverts its edits if the browser takes it, for a gesture", () => {
    const { intents, fire } = open();
    fire("down", 215, 115);
    fire("cancel");
    expect(intents.at(-1)).toEqual({ type: "cancel" });
  });

  it("does nothing while the user drives on a phone, nor after the stage has closed", () => {
    const { camera, intents, stop, fire } = open();
    camera.setState({ isDriving: true });
    fire("down", 215, 115);
    fire("leave");
    camera.setState({ isDriving: false });
    stop();
    fire("down", 215, 115);
    expect(intents).toEqual([]);
  });
});
