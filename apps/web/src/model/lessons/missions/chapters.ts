/** The chapters of the path: missions in their order, grouped by the ideas of docs/lessons.md. */
import type { MissionId } from "./mission.ts";

export const chapterIds = ["robot", "lines", "turns", "mazes"] as const;
export type ChapterId = (typeof chapterIds)[number];

export const chapters: Readonly<Record<ChapterId, readonly MissionId[]>> = {
  robot: ["make-it-move", "how-far"],
  lines: ["one-line", "first-true-line", "centimetres", "own-line"],
  turns: ["side-opening", "no-room", "order-of-lines", "faulty-line"],
  mazes: ["right-wall", "every-maze", "left-or-right", "farthest-distance"],
};
