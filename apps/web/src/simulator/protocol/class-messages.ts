/** The class of this page's student, in messages between the page and the simulator worker. */
import type { StudentName } from "@corridor/protocol";

export type ClassRequest =
  /** connects, or reconnects at once; `id` is that of the class */
  | { kind: "open"; id: string; key: string }
  | { kind: "close" }
  /** whether the student asks the teacher for help */
  | { kind: "help"; wanted: boolean }
  /** asks for another name */
  | { kind: "name" };

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
}

export interface ClassSession {
  status: ClassStatus;
  /** null before the first connection */
  student: ClassStudent | null;
}
