/**
 * Mistakes of the students in the study of 2013 (chapter 4 of the thesis), and the missions that
 * cover them.
 */
import type { MissionId } from "../mission.ts";

export interface StudyMistake {
  mistake: string;
  /** of 28 students; null if the thesis gives no number */
  students: number | null;
  missions: readonly MissionId[];
}

export const studyMistakes: readonly StudyMistake[] = [
  {
    mistake: "Left out “delayed” where it was needed",
    students: 3,
    missions: ["side-opening", "right-wall"],
  },
  {
    mistake: "Delayed a turn where there was no room (Figure 25)",
    students: null,
    missions: ["no-room", "right-wall"],
  },
  {
    mistake: "Believed that a wrong program was right",
    students: 3,
    missions: ["every-maze", "left-or-right", "farthest-distance"],
  },
  {
    mistake: "Had the lines in the wrong order",
    students: 1,
    missions: ["first-true-line", "order-of-lines"],
  },
  {
    mistake: "Could not relate numbers to distances",
    students: null,
    missions: ["how-far", "centimetres"],
  },
  {
    mistake: "Could not find the faulty line",
    students: null,
    missions: ["faulty-line"],
  },
  {
    mistake: "Took the wrong condition or command (Figure 24)",
    students: null,
    missions: ["one-line", "own-line"],
  },
];
