/**
 * Maps key presses to shortcuts. Pure: of the DOM it needs only the kind of the focused element.
 */
import type { DriveKey } from "../simulator/protocol/worker-messages.ts";

/**
 * Kind of the focused element:
 *
 * - text: letters are typed
 * - choice: arrows and letters choose (a select)
 * - grid: the maze's cells
 * - radio: arrows choose (a radio group, tabs)
 * - slider: arrows move it (the timeline)
 * - button: Space and Enter press it
 * - page: nothing special
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
  // The plus key of many keyboards without Shift.
  "=": "in",
  "-": "out",
  "0": "fit",
};

/**
 * @param singleKeys false if the user switched off shortcuts without Ctrl
 * @returns the shortcut, or null if the press belongs to the focused element or has no function
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

function commandShortcut(press: KeyPress, place: Place): Shortcut | null {
  const { key, shift } = press;
  if (key === "Enter") return { kind: shift ? "step" : "run-or-pause" };
  if (letterOf(press) !== "z" || place === "text") return null;
  return { kind: shift ? "redo" : "undo" };
}

function driveKey(press: KeyPress, place: Place): DriveKey | null {
  const { key } = press;
  if (key === " ") return place === "page" || place === "slider" ? "stop" : null;
  if (place !== "radio" && place !== "slider" && arrows[key] !== undefined) return arrows[key];
  return letters[letterOf(press)] ?? null;
}

/** On keyboards without Latin letters, the physical positions count. */
function letterOf({ key, code }: KeyPress): string {
  return (/^[a-z]$/i.test(key) ? key : code.replace("Key", "")).toLowerCase();
}
