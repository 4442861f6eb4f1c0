import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { cellsBetween, PointerInput, type Intent, type PointerDetails } from "./pointer-input.ts";

const at = (column: number, row: number) => ({ column, row });

function pointer(facts: Partial<PointerDetails>): PointerDetails {
  return { pointerId: 1, pointerType: "mouse", button: 0, isPrimary: true, cell: null, ...facts };
}

function newInput(doesTouchScroll = false) {
  const intents: Intent[] = [];
  const input = new PointerInput((intent) => intents.push(intent));
  input.setTouchScroll(doesTouchScroll);
  return { input, intents };
}

describe("a mouse over the maze", () => {
  it("shows a preview of a press, and none once it has left", () => {
    const { input, intents } = newInput();
    input.move(pointer({ cell: at(2, 3) }));
    input.leave();
    expect(intents).toEqual([
      { type: "hover", cell: at(2, 3) },
      { type: "hover", cell: null },
    ]);
  });

  it("paints at the press, over every cell of the drag, and ends once", () => {
    const { input, intents } = newInput();
    input.down(pointer({ cell: at(1, 1) }));
    input.move(pointer({ cell: at(1, 1) }));
    input.move(pointer({ cell: at(4, 1) }));
    input.up(pointer({ cell: at(4, 1) }));
    expect(intents).toEqual([
      { type: "hover", cell: null },
      { type: "begin", cell: at(1, 1) },
      { type: "paint", cells: [at(2, 1), at(3, 1), at(4, 1)] },
      { type: "end" },
      { type: "hover", cell: at(4, 1) },
    ]);
  });

  it("continues to paint after it was outside of the maze", () => {
    const { input, intents } = newInput();
    input.down(pointer({ cell: at(0, 0) }));
    input.move(pointer({ cell: null }));
    input.move(pointer({ cell: at(0, 1) }));
    expect(intents.at(-1)).toEqual({ type: "paint", cells: [at(0, 1)] });
  });

  it.each([
    { name: "the right button", facts: { button: 2, cell: at(1, 1) } },
    { name: "a press on a ruler", facts: { cell: null } },
  ])("does nothing on $name", ({ facts }) => {
    const { input, intents } = newInput();
    input.down(pointer(facts));
    input.up(pointer(facts));
    expect(intents).toEqual([]);
  });

  it("undoes a cancelled stroke", () => {
    const { input, intents } = newInput();
    input.down(pointer({ cell: at(1, 1) }));
    input.cancel();
    input.up(pointer({ cell: at(1, 1) }));
    expect(intents.slice(1)).toEqual([{ type: "begin", cell: at(1, 1) }, { type: "cancel" }]);
  });
});

describe("a finger", () => {
  const finger = (facts: Partial<PointerDetails>) => pointer({ pointerType: "touch", ...facts });

  it("paints where the whole maze shows", () => {
    const { input, intents } = newInput();
    input.down(finger({ cell: at(1, 1) }));
    input.move(finger({ cell: at(1, 2) }));
    input.up(finger({ cell: at(1, 2) }));
    expect(intents.map(({ type }) => type)).toEqual(["hover", "begin", "paint", "end"]);
  });

  it("that comes second is a pinch and undoes the stroke", () => {
    const { input, intents } = newInput();
    input.down(finger({ cell: at(1, 1) }));
    input.down(finger({ cell: at(3, 3), pointerId: 2, isPrimary: false }));
    expect(intents.at(-1)).toEqual({ type: "cancel" });
  });

  it("edits by a tap where a drag scrolls", () => {
    const { input, intents } = newInput(true);
    input.down(finger({ cell: at(1, 1) }));
    expect(intents).toEqual([]);
    input.up(finger({ cell: at(1, 1) }));
    expect(intents).toEqual([{ type: "begin", cell: at(1, 1) }, { type: "end" }]);
  });

  it("scrolls a large maze without changing it", () => {
    const { input, intents } = newInput(true);
    input.down(finger({ cell: at(1, 1) }));
    input.move(finger({ cell: at(1, 4) }));
    input.cancel();
    input.up(finger({ cell: at(1, 4) }));
    expect(intents).toEqual([]);
  });
});

describe("cellsBetween", () => {
  it("leaves no gap and ends at the last cell, however fast the pointer moves", () => {
    const cell = fc.record({ column: fc.nat(255), row: fc.nat(255) });
    fc.assert(
      fc.property(cell, cell, (from, to) => {
        let last = from;
        for (const next of cellsBetween(from, to)) {
          expect(Math.abs(next.column - last.column)).toBeLessThanOrEqual(1);
          expect(Math.abs(next.row - last.row)).toBeLessThanOrEqual(1);
          expect(next).not.toEqual(last);
          last = next;
        }
        expect(last).toEqual(to);
      }),
    );
  });
});
