/** The class of this page's student, in messages between the page and the simulator worker. */
import type { RelayToStudent, StudentName, StudentToRelay, Tile } from "@corridor/protocol";

export type ClassRequest =
  /** connects, or reconnects at once; `id` is that of the class */
  | { kind: "open"; id: string; key: string }
  | { kind: "close" }
  /** whether the student asks the teacher for help */
  | { kind: "help"; wanted: boolean }
  /** asks for another name */
  | { kind: "name" }
  /** sends a report once; the page repeats it until it is stored */
  | { kind: "send"; report: ClassReport }
  /** what the student works on; null: on nothing of the class's lesson */
  | { kind: "place"; place: ClassPlace | null };

/** What the relay stores and confirms. */
export type ClassReport = Extract<StudentToRelay, { type: "progress" | "program" }>;

/** What a tile contains besides the run. */
export interface ClassPlace extends Pick<Tile, "task" | "maze" | "passes"> {
  /** whether the open task is solved */
  isSolved: boolean;
  /** whether a hand or a script drives, also while the robot waits for the next command */
  isDriven: boolean;
}

/** A hint that the teacher shows. */
export type ClassHint = Omit<Extract<RelayToStudent, { type: "hint" }>, "type">;

/** Why the student is not in the class on this page: `replaced` by another tab or device. */
export type ClassEnding = "removed" | "replaced" | "over";

export type ClassStatus =
  /** lost: the worker reconnects by itself */
  { kind: "connecting" | "connected" | "lost" } | { kind: "over"; reason: ClassEnding };

/** The student as the relay sees it. */
export interface ClassStudent {
  name: StudentName;
  renamesLeft: number;
  /** refused: all names are in use */
  rename: "possible" | "requested" | "refused";
  helpWanted: boolean;
  /** whether a teacher watches */
  watched: boolean;
  /** end of the pause, in milliseconds since 1970; null: the class is not paused */
  pauseEndsAt: number | null;
  /** version of the class's lesson */
  lesson: string;
  /** the tasks up to this number are open; null: all */
  paceTo: number | null;
  /** number of the newest stored record, and of the newest stored program of this page */
  stored: { progress: number; program: number };
}

export interface ClassSession {
  status: ClassStatus;
  /** null before the first connection */
  student: ClassStudent | null;
}
