import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { activeKey, createHoldStore } from "./hold-store.ts";
import type { DriveKey } from "../../simulator/protocol/worker-messages.ts";

function setUp() {
  const sent: DriveKey[] = [];
  return { sent, hold: createHoldStore((key) => sent.push(key)) };
}

describe("holding drive keys", () => {
  it("drives while a key is held and stops when it is released", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.release("w");
    expect(sent).toEqual(["forward", "stop"]);
  });

  it("counts no press that may not drive", () => {
    const sent: DriveKey[] = [];
    const hold = createHoldStore(
      (key) => sent.push(key),
      (key) => key !== "left",
    );
    hold.press("a", "left");
    hold.press("w", "forward");
    hold.release("a");
    hold.release("w");
    expect(sent).toEqual(["forward", "stop"]);
  });

  it("follows the key pressed last, and returns to the other when it is released", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.press("a", "left");
    hold.release("a");
    hold.release("w");
    expect(sent).toEqual(["forward", "left", "forward", "stop"]);
  });

  it("continues when the key pressed first is released first", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.press("a", "left");
    hold.release("w");
    expect(sent).toEqual(["forward", "left"]);
  });

  it("sends nothing again while the keyboard repeats a held key", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.press("w", "forward");
    expect(sent).toEqual(["forward"]);
  });

  it("drives on while one of two fingers still holds the same key", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.press("pointer 1", "forward");
    hold.release("w");
    expect(sent).toEqual(["forward"]);
    hold.release("pointer 1");
    expect(sent).toEqual(["forward", "stop"]);
  });

  it("stops once when the window loses its focus", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.press("d", "right");
    hold.releaseAll();
    hold.release("w");
    hold.releaseAll();
    expect(sent).toEqual(["forward", "right", "stop"]);
  });

  it("rests at the goal until the key is released and pressed again", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.arrive();
    expect(activeKey(hold.getState())).toBeNull();
    // A keyboard repeats a held key.
    hold.press("w", "forward");
    expect(sent).toEqual(["forward", "stop"]);
    hold.release("w");
    hold.press("w", "forward");
    expect(sent).toEqual(["forward", "stop", "forward"]);
  });

  it("drives on from the goal by another key, and rests when that is released", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.arrive();
    hold.press("s", "reverse");
    hold.release("s");
    expect(sent).toEqual(["forward", "stop", "reverse", "stop"]);
  });

  it("sends nothing when another driver has taken over", () => {
    const { sent, hold } = setUp();
    hold.press("w", "forward");
    hold.clear();
    hold.release("w");
    expect(sent).toEqual(["forward"]);
  });

  it("has stopped the robot whenever no key is held, whatever was pressed", () => {
    const source = fc.constantFrom("w", "a", "s", "d", "pointer");
    const key = fc.constantFrom<DriveKey>("forward", "reverse", "left", "right", "stop");
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.boolean(), source, key)), (events) => {
        const { sent, hold } = setUp();
        for (const [isPress, from, what] of events) {
          if (isPress) hold.press(from, what);
          else hold.release(from);
        }
        expect(sent.at(-1) ?? "stop").toBe(activeKey(hold.getState()) ?? "stop");
      }),
    );
  });
});
