import { describe, expect, it } from "vitest";
import { layOut } from "../../stage/drawing/viewport.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { MeasureTool } from "./measure-tool.ts";
import { createStageView } from "../../stage/page/stage-view.ts";
import { tapePointAt, tapeWords, type Tape } from "../../stage/page/tape.ts";

const none = { top: 0, right: 0, bottom: 0, left: 0 };
const layout = layOut({ columns: 11, rows: 7 }, { width: 880, height: 560 }, none, 30);

function newTool() {
  const view = createStageView();
  return { tool: new MeasureTool(view), tape: () => view.getState().tape };
}

describe("a tape by dragging", () => {
  it("goes from where the pointer went down to where it is, and stays", () => {
    const { tool, tape } = newTool();
    tool.begin(1, { x: 50, y: 650 });
    tool.drag(1, { x: 200, y: 650 });
    expect(tape()).toEqual({ from: { x: 50, y: 650 }, to: { x: 200, y: 650 }, isOpen: true });
    tool.end(1);
    tool.drag(1, { x: 900, y: 650 });
    expect(tape()).toEqual({ from: { x: 50, y: 650 }, to: { x: 200, y: 650 }, isOpen: false });
  });

  it("ignores another finger", () => {
    const { tool, tape } = newTool();
    tool.begin(1, { x: 0, y: 0 });
    tool.drag(2, { x: 500, y: 500 });
    tool.end(2);
    expect(tape()).toMatchObject({ to: { x: 0, y: 0 }, isOpen: true });
  });

  it("leaves nothing behind after a mere press", () => {
    const { tool, tape } = newTool();
    tool.begin(1, { x: 50, y: 50 });
    tool.end(1);
    expect(tape()).toBeNull();
  });

  it("stays inside the maze, at whole centimetres", () => {
    expect(tapePointAt(layout, -20, 9000)).toEqual({ x: 0, y: 700 });
    expect(tapePointAt(layout, 40.3, 40)).toEqual({ x: 50, y: 50 });
  });
});

describe("a tape by keyboard", () => {
  it("begins in the middle of a square, follows the cursor and ends with the second press", () => {
    const { tool, tape } = newTool();
    tool.press({ column: 0, row: 6 });
    tool.aim({ column: 2, row: 6 });
    expect(tape()).toMatchObject({ to: { x: 250, y: 650 }, isOpen: true });
    tool.press({ column: 3, row: 6 });
    tool.aim({ column: 9, row: 6 });
    expect(tape()).toEqual({ from: { x: 50, y: 650 }, to: { x: 350, y: 650 }, isOpen: false });
  });

  it("goes away when it is cleared, once", () => {
    const { tool, tape } = newTool();
    tool.press({ column: 0, row: 0 });
    expect(tool.clear()).toBe(true);
    expect(tape()).toBeNull();
    expect(tool.clear()).toBe(false);
  });
});

describe("the text of a tape", () => {
  const { t } = createI18n(en);
  const tape = (x: number, y: number): Tape => ({
    from: { x: 50, y: 50 },
    to: { x, y },
    isOpen: false,
  });
  it.each([
    { name: "along a row", to: tape(300, 50), words: ["250 cm, 2.5 squares"] },
    { name: "one square", to: tape(50, 150), words: ["100 cm, 1 square"] },
    {
      name: "a slanting one",
      to: tape(350, 450),
      words: ["500 cm, 5 squares", "300 cm across, 400 cm down"],
    },
  ])("$name", ({ to, words }) => {
    expect(tapeWords(t, "en", to)).toEqual(words);
  });

  it("names the direction of a tape that goes up", () => {
    const up: Tape = { from: { x: 0, y: 400 }, to: { x: 300, y: 0 }, isOpen: false };
    expect(tapeWords(t, "en", up)[1]).toBe("300 cm across, 400 cm up");
  });

  it("has the decimal sign of the language", () => {
    expect(tapeWords(t, "de", tape(300, 50))[0]).toContain("2,5");
  });
});
