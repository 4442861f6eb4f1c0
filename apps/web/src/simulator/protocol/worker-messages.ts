/**
 * All messages between the page's main thread and the simulator worker. Documents are parsed and
 * checked before they are sent.
 */
import type { Judgement, Task } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { RegistrationError } from "@corridor/client/host";
import type {
  closeReasons,
  CommandRecord,
  DriverName,
  FieldProblem,
  LineRef,
  Pose,
  ScriptView,
  TimedCommand,
} from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RunDocument, TimelineDelta, WrittenRun } from "@corridor/recording";
import type { BumpCause } from "@corridor/simulation";
import type { CancelReason } from "./cancel-reason.ts";
import type { ClassHint, ClassRequest, ClassSession } from "./class-messages.ts";
import type { Frame } from "../../stage/drawing/frame.ts";
import type { StageFromWorker, StageToWorker } from "../../stage/stage-messages.ts";

/** Simulated seconds per second; "max" is as many as the machine can. */
export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16, "max"] as const;
export type Speed = (typeof speeds)[number];

/** How far Step goes: to the next change of decision, or one tick. */
export type StepLength = "decision" | "tick";

/** A held drive key: forward and reverse drive, left and right turn on the spot. */
export type DriveKey = "forward" | "reverse" | "left" | "right" | "stop";

/** What the page needs to host its robot at the relay; `ownerKey` is sent only to the relay. */
export interface RemoteSession {
  id: string;
  ownerKey: string;
  driverKey: string;
  /** the robot's address with the driver key in its fragment, for scripts */
  address: string;
  /** highest seq of a command that this page has started */
  lastApplied: number;
}

/**
 * Opens a run where it ended, paused; answered by `run-loaded` with the same id. Until then the
 * current run continues; Reset, or another run, cancels the request.
 */
export interface LoadRun {
  type: "load-run";
  id: number;
  run: RunDocument;
}

/** The same for this tab's run from before a reload. */
export interface RestoreRun {
  type: "restore-run";
  id: number;
  /** key of the stored run */
  key: string;
  /**
   * whether the current project was open when the page was left; otherwise the run's documents
   * decide
   */
  isSameProject: boolean;
  /**
   * when the run began whose robot was displayed at its start then, in ms since 1970: a stored run
   * that began earlier ended by a reset. null: the robot had moved
   */
  atStartSince: number | null;
}

/** Adds a recorded run of the same maze to the race; answered by `ghost-added` with the same id. */
export interface AddGhost {
  type: "add-ghost";
  id: number;
  /** the letter of the ghost */
  badge: string;
  run: RunDocument;
}

export type ToWorker =
  | StageToWorker
  /** the first message: the page's documents */
  | { type: "load"; maze: MazeDocument; program: ProgramDocument }
  /** the maze changed: the robot stays where it is, or is moved to its start if it has no room */
  | { type: "edit-maze"; maze: MazeDocument }
  | { type: "edit-program"; program: ProgramDocument }
  | { type: "run" }
  | { type: "pause" }
  /** continues to the next change of decision, or by one tick, then pauses */
  | { type: "step"; length: StepLength }
  /** moves the robot to its start; everything else stays */
  | { type: "reset" }
  /** pauses and displays the state at the end of a tick everywhere */
  | { type: "seek"; tick: number }
  /** pauses and displays the previous or next decision */
  | { type: "seek-step"; by: 1 | -1 }
  /** plays the recording from the displayed tick to the newest; changes nothing */
  | { type: "play" }
  /** displays the newest tick again */
  | { type: "now" }
  /** truncates the run at the displayed tick and continues from it */
  | { type: "run-here" }
  | LoadRun
  | RestoreRun
  /** whether the tab could store the key of `run-key` */
  | { type: "run-key-noted"; ok: boolean }
  /** cancels opening a run, which is answered as cancelled */
  | { type: "cancel-load"; id: number }
  /**
   * requests the run so far, answered by `run-saved`; a run that is too long for a document is
   * refused
   */
  | { type: "save-run"; id: number }
  | AddGhost
  /** removes a ghost from the race */
  | { type: "remove-ghost"; id: number }
  /**
   * judges the run by a maze of a task, answered by `judgement` with the same id; null: by
   * none
   */
  | { type: "judge"; id: number; attempt: { task: Task; maze: number } | null }
  | { type: "speed"; speed: Speed }
  | { type: "driver"; driver: DriverName }
  /** the same, if the run has not started and no other driver was chosen */
  | { type: "offer-driver"; driver: DriverName }
  | { type: "hold"; key: DriveKey }
  | { type: "remote-open"; session: RemoteSession | null; fresh: boolean }
  | { type: "remote-close" }
  | { type: "remote-clear" }
  /** whether marks of scripts are drawn over the maze */
  | { type: "hide-marks"; isHidden: boolean }
  | { type: "class"; request: ClassRequest }
  /** the teacher pauses the class, or ends the pause: nothing moves the robot meanwhile */
  | { type: "class-pause"; isPaused: boolean }
  /** runs a program, or commands at given ticks, without the robot and answers with the digest */
  | {
      type: "digest";
      maze: MazeDocument;
      driver: ProgramDocument | readonly TimedCommand[];
      ticks: number;
    };

/** Result of one run of a race, at the goal or at its end if it reached none. */
export interface Finish {
  /** null: the run ended before it reached the goal */
  goalTick: number | null;
  /** up to the goal or the end */
  bumps: number;
  driver: DriverName;
  /** lines of the program that do something */
  lines: number;
}

/** The answer to `add-ghost`: the result of the run, or why it cannot be repeated. */
export type AddedGhost =
  | { ok: true; finish: Finish }
  /** without problems: the simulator broke, or the race is full */
  | { ok: false; problems: FieldProblem[] };

/** A bump or the goal. `line` is null if no program line was in charge. */
export interface RunEvent {
  kind: "bump" | "goal";
  tick: number;
  pose: Pose;
  line: LineRef | null;
  driver: DriverName;
  /** bumps so far, including this one */
  bumps: number;
  /** how the bump came about; null for the goal */
  cause: BumpCause | null;
  /**
   * why it happened; null for the goal, for a bump by hand, and for a line whose bump was explained
   * before
   */
  diagnosis: Diagnosis | null;
  /**
   * the program that drove, if the page explains the event: the page's program may have been edited
   * since; null for a bump that does not pause the run
   */
  program: ProgramDocument | null;
}

/** Connection of the page to the relay and of scripts to the robot. */
export type RemoteStatus =
  | { kind: "off" }
  | { kind: "connecting" }
  | { kind: "waiting" }
  /**
   * `seenAt`: milliseconds since 1970, because the clocks of worker and page have different
   * origins
   */
  | { kind: "connected"; client: string; seenAt: number }
  /** not connected; the page reconnects by itself, unless the service has no robot for it */
  | { kind: "lost"; reason: RemoteTrouble }
  /** the session has ended for this page */
  | { kind: "over"; reason: RemoteTrouble };

/** Why there is no connection: the name of a close code, or another error. */
export type RemoteTrouble =
  | keyof typeof closeReasons
  | Exclude<RegistrationError["code"], "noAnswer">
  /** the connection broke without a close code, or nothing responds */
  | "connectionLost";

/** A command for this page's robot, and its state. */
export interface ListedCommand extends Omit<CommandRecord, "reason"> {
  /** why this page ended it early */
  reason: CancelReason | null;
  /** ttl of the command in ms */
  ttl: number;
}

/** A script in the panel. */
export interface ListedScript extends Omit<ScriptView, "silentMs"> {
  /** milliseconds since 1970; null: not recently */
  seenAt: number | null;
}

export interface RemoteView {
  status: RemoteStatus;
  session: RemoteSession | null;
  /** newest first, at most 100 */
  commands: ListedCommand[];
  scripts: ListedScript[];
  /** remote driving is paused by its owner */
  isPaused: boolean;
  /** scripts may reset the robot */
  mayReset: boolean;
}

/** The answer to `load-run`: the last documents of the run, or why nothing was loaded. */
export type LoadedRun =
  | { ok: true; maze: MazeDocument; program: ProgramDocument }
  /** it cannot be repeated */
  | { ok: false; reason: "refused"; problems: FieldProblem[] }
  /** the stored run is of another project or from before a reset, or there is none */
  | { ok: false; reason: "other-run" | "not-stored" }
  /** cancelled by another request, or the simulator broke, which is reported as a fault */
  | { ok: false; reason: "cancelled" | "fault" };

/** The answer to `save-run`: the text of the document and its ticks, or why there is none. */
export type SavedRun =
  | { ok: true; text: string; ticks: number }
  | Extract<WrittenRun, { ok: false }>;

export type FromWorker =
  /**
   * throttled for the panels, and at once after important changes, with the changes of the
   * timeline: one message, so that the page draws both together
   */
  | { type: "frame"; frame: Frame; timeline: TimelineDelta | null }
  | StageFromWorker
  /**
   * the run was truncated after this tick and continues differently; -1: it is another run.
   * Precedes the frames and events of the continued run.
   */
  | { type: "truncated"; after: number }
  | { type: "event"; event: RunEvent }
  /** why the program's robot does not reach the goal; sent once, and again when the time is over */
  | { type: "diagnosed"; program: ProgramDocument; diagnosis: Diagnosis }
  /** the judgement for the newest `judge`, on each change; initially open */
  | { type: "judgement"; id: number; judgement: Judgement }
  /** the maze at the displayed tick if it is not the newest one; otherwise null */
  | { type: "past-maze"; maze: MazeDocument | null }
  /**
   * key of the stored run for a reload; null: this device cannot store it, and a reload starts at
   * the start. Answered by `run-key-noted`
   */
  | { type: "run-key"; key: string | null }
  | { type: "run-saved"; id: number; saved: SavedRun }
  /** progress of opening a long run, from 0 to 1 */
  | { type: "run-loading"; id: number; part: number }
  | { type: "run-loaded"; id: number; loaded: LoadedRun }
  | { type: "ghost-added"; id: number; added: AddedGhost }
  | { type: "remote"; remote: RemoteView }
  /** the student's class, on each change */
  | { type: "class"; session: ClassSession }
  | { type: "class-hint"; hint: ClassHint }
  | { type: "digest"; digest: string }
  | { type: "fault"; reason: string };
