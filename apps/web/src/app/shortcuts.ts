/**
 * What a key press asks of the page (DESIGN-LANGUAGE: keys). Pure: the DOM is asked only what kind
 * of place has the focus.
 */
import type { DriveKey } from "../worker/worker-messages.ts";

/**
 * Where the focus is. text: letters are typed; choice: arrows and letters choose (a select), grid:
 * the maze's squares; radio: arrows choose (a radio group, tabs); slider: arrows move it (the timeline); button: Space and Enter press it; page: nowhere special.
 */
export type Place = "text" | "choice" | "grid" | "radio" | "slider" | "button" | "page";

export interface KeyPress {
  /** `KeyboardEvent.key` and `.code` */
  key: string;
  code: string;
  /** Ctrl, or Command on a Mac */
  command: boolean;
  shift: boolean;
  alt: boolean;
}

export type Shortcut =
  | { kind: "run-or-pause" | "step" | "undo" | "redo" | "help" | "describe" | "escape" }
  | { kind: "zoom"; by: "in" | "out" | "fit" }
  | { kind: "drive"; key: DriveKey };

const letters: Readonly<Record<string, DriveKey>> = {
  w: "forward",
  a: "left",
  s: "reverse",
  d: "right",
};
const arrows: Readonly<Record<string, DriveKey>> = {
  ArrowUp: "forward",
  ArrowLeft: "left",
  ArrowDown: "reverse",
  ArrowRight: "right",
};

const zooms: Readonly<Record<string, "in" | "out" | "fit">> = {
  "+": "in",
  // The plus of many keyboards without Shift.
  "=": "in",
  "-": "out",
  "0": "fit",
};

/**
 * @param singleKeys false when the user switched off the keys that work without Ctrl
 * @returns what it asks for, or null when the press belongs to the focused element or to nobody
 */
export function shortcutOf(press: KeyPress, place: Place, singleKeys: boolean): Shortcut | null {
  if (press.alt) return null;
  if (press.command) return commandShortcut(press, place);
  if (press.key === "Escape") return { kind: "escape" };
  if (!singleKeys || place === "text" || place === "choice") return null;
  if (press.key === "?") return { kind: "help" };
  const by = zooms[press.key];
  if (by !== undefined) return { kind: "zoom", by };
  if (press.shift) return null;
  if (letterOf(press) === "i") return { kind: "describe" };
  if (place === "grid") return null;
  const key = driveKey(press, place);
  return key === null ? null : { kind: "drive", key };
}

function commandShortcut({ key, shift }: KeyPress, place: Place): Shortcut | null {
  if (key === "Enter") return { kind: shift ? "step" : "run-or-pause" };
  if (key.toLowerCase() !== "z" || place === "text") return null;
  return { kind: shift ? "redo" : "undo" };
}

function driveKey(press: KeyPress, place: Place): DriveKey | null {
  const { key } = press;
  if (key === " ") return place === "page" || place === "slider" ? "stop" : null;
  if (place !== "radio" && place !== "slider" && arrows[key] !== undefined) return arrows[key];
  return letters[letterOf(press)] ?? null;
}

/** Where the keyboard has no Latin letters, the places of W, A, S and D count. */
function letterOf({ key, code }: KeyPress): string {
  return (/^[a-z]$/i.test(key) ? key : code.replace("Key", "")).toLowerCase();
}
