/**
 * Preset programs. Never change an id: saved projects, tests and the page's translations refer to
 * it. Figure numbers refer to the 2013 thesis.
 */
import type { ProgramDocument, Rule } from "./program-document.ts";

const programPresetIds = [
  "back-and-forth",
  "right-wall",
  "left-wall",
  "farthest-distance",
  "left-at-every-wall",
] as const;
export type ProgramPresetId = (typeof programPresetIds)[number];

export interface ProgramPreset {
  id: ProgramPresetId;
  program: ProgramDocument;
}

function preset(id: ProgramPresetId, name: string, rules: Rule[]): ProgramPreset {
  return {
    id,
    program: { format: "corridor/program", version: 1, name, default: "forward", rules },
  };
}

/** All preset programs, in menu order. */
export const programPresets: readonly ProgramPreset[] = [
  // Figure 19
  preset("back-and-forth", "Back and forth", [
    { when: { sensor: "front", is: "<", than: 50 }, do: "turn 180" },
  ]),
  // Figure 22
  preset("right-wall", "Right wall", [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ]),
  // Figure 22, mirrored
  preset("left-wall", "Left wall", [
    { when: { sensor: "left", is: ">", than: 60 }, do: "delayed left 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "right 90" },
  ]),
  // Figure 23
  preset("farthest-distance", "Farthest distance", [
    { when: { sensor: "front", is: ">", than: 50 }, do: "forward" },
    { when: { sensor: "left", is: ">", than: "right", plus: 1 }, do: "left 90" },
    { when: { sensor: "left", is: "<", than: "right", plus: 1 }, do: "right 90" },
  ]),
  preset("left-at-every-wall", "Left at every wall", [
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ]),
];
