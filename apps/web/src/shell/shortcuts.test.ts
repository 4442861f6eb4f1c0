import { describe, expect, it } from "vitest";
import { shortcutOf, type KeyPress, type Place } from "./shortcuts.ts";

function press(key: string, changes: Partial<KeyPress> = {}): KeyPress {
  const code = /^[a-z]$/i.test(key) ? `Key${key.toUpperCase()}` : key;
  return { key, code, command: false, shift: false, alt: false, ...changes };
}

const everywhere: readonly Place[] = [
  "text",
  "choice",
  "grid",
  "radio",
  "slider",
  "button",
  "page",
];

describe("shortcutOf", () => {
  it.each([
    ["w", "forward"],
    ["a", "left"],
    ["s", "reverse"],
    ["d", "right"],
    ["W", "forward"],
    ["ArrowUp", "forward"],
    ["ArrowLeft", "left"],
    ["ArrowDown", "reverse"],
    ["ArrowRight", "right"],
    [" ", "stop"],
  ])("drives with %j: %s", (key, drive) => {
    expect(shortcutOf(press(key), "page", true)).toEqual({ kind: "drive", key: drive });
  });

  it("drives by the physical position of the keys on a keyboard without Latin letters", () => {
    expect(shortcutOf(press("ц", { code: "KeyW" }), "page", true)).toEqual({
      kind: "drive",
      key: "forward",
    });
  });

  it.each<[string, Place]>([
    ["w", "text"],
    ["w", "choice"],
    ["w", "grid"],
    ["ArrowUp", "text"],
    ["ArrowUp", "choice"],
    ["ArrowUp", "grid"],
    ["ArrowUp", "radio"],
    ["ArrowLeft", "slider"],
    [" ", "button"],
    [" ", "radio"],
    [" ", "grid"],
    ["?", "text"],
    ["i", "text"],
    ["i", "choice"],
    ["x", "page"],
  ])("leaves %j to a focused %s", (key, place) => {
    expect(shortcutOf(press(key), place, true)).toBeNull();
  });

  it.each(["button", "radio", "slider"] as const)(
    "drives with W while a %s has the focus",
    (place) => {
      expect(shortcutOf(press("w"), place, true)).not.toBeNull();
    },
  );

  it.each(everywhere)("runs, steps and stops from anywhere: %s", (place) => {
    expect(shortcutOf(press("Enter", { command: true }), place, false)).toEqual({
      kind: "run-or-pause",
    });
    expect(shortcutOf(press("Enter", { command: true, shift: true }), place, false)).toEqual({
      kind: "step",
    });
    expect(shortcutOf(press("Escape"), place, false)).toEqual({ kind: "escape" });
  });

  it("undoes and redoes, but leaves a text field its own undo", () => {
    expect(shortcutOf(press("z", { command: true }), "grid", true)).toEqual({ kind: "undo" });
    expect(shortcutOf(press("Z", { command: true, shift: true }), "page", true)).toEqual({
      kind: "redo",
    });
    expect(shortcutOf(press("z", { command: true }), "text", true)).toBeNull();
    const arabic = press("ئ", { code: "KeyZ", command: true });
    expect(shortcutOf(arabic, "page", true)).toEqual({ kind: "undo" });
  });

  it.each(["w", "ArrowUp", " ", "?", "i"])("does nothing on %j when single keys are off", (key) => {
    expect(shortcutOf(press(key), "page", false)).toBeNull();
  });

  it("opens the list with ? unless a text is typed", () => {
    expect(shortcutOf(press("?", { shift: true }), "grid", true)).toEqual({ kind: "help" });
  });

  it.each(["grid", "radio", "slider", "button", "page"] as const)(
    "describes the robot with I from a %s",
    (place) => {
      expect(shortcutOf(press("i"), place, true)).toEqual({ kind: "describe" });
      expect(shortcutOf(press("ш", { code: "KeyI" }), place, true)).toEqual({ kind: "describe" });
    },
  );

  it("leaves combinations with Alt and other Ctrl keys to the browser", () => {
    expect(shortcutOf(press("ArrowLeft", { alt: true }), "page", true)).toBeNull();
    expect(shortcutOf(press("s", { command: true }), "page", true)).toBeNull();
  });
});
