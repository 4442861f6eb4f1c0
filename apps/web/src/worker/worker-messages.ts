/**
 * Everything that crosses between the page's main thread and the simulator worker, and nothing else.
 * Documents were parsed and checked before they are sent; both ends are our own code.
 */
import type { ChallengeDocument, Judgement } from "@corridor/challenge";
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
  Snapshot,
  TimedCommand,
} from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RunDocument, TimelineDelta, WrittenRun } from "@corridor/recording";
import type { BumpCause, Progress } from "@corridor/simulation";
import type { Scroll } from "../canvas/viewport.ts";
import type { CancelReason } from "../drivers/cancel-reason.ts";
import type { StageToWorker } from "./stage-messages.ts";

/** How many simulated seconds pass in one second; "max" is as many as the machine gives. */
export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16, "max"] as const;
export type Speed = (typeof speeds)[number];

/** Ghosts of one race: more would hide each other. */
export const MAX_GHOSTS = 4;

/** How far Step goes: to the next change of decision, or one tick. */
export type StepLength = "decision" | "tick";

/** A held drive key: forward and reverse drive, left and right turn on the spot. */
export type DriveKey = "forward" | "reverse" | "left" | "right" | "stop";

/** What the page needs to host its robot at the relay; `ownerKey` never leaves this device but to the relay. */
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
 * Opens a run where it ended, and pauses; answered by `run-loaded` with the same id. Until then the run that is
 * there goes on; Reset, or another run, gives this one up.
 */
export interface LoadRun {
  type: "load-run";
  id: number;
  run: RunDocument;
}

/** The same for the run that this tab had before a reload. */
export interface RestoreRun {
  type: "restore-run";
  id: number;
  /** of the stored run */
  key: string;
  /** whether the project was the one that is open now when the page was left; else the run's documents decide */
  isSameProject: boolean;
}

/** Adds a recorded run of the same maze to the race; answered by `ghost-added` with the same id. */
export interface AddGhost {
  type: "add-ghost";
  id: number;
  /** the letter that it is drawn with */
  badge: string;
  run: RunDocument;
}

export type ToWorker =
  | StageToWorker
  /** the first message: what the page starts with */
  | { type: "load"; maze: MazeDocument; program: ProgramDocument }
  /** the maze changed under the robot: it stays where it is, or goes to its start where it no longer fits */
  | { type: "edit-maze"; maze: MazeDocument }
  | { type: "edit-program"; program: ProgramDocument }
  | { type: "run" }
  | { type: "pause" }
  /** goes on to the next change of decision, or by one tick, then pauses */
  | { type: "step"; length: StepLength }
  /** robot to start, everything else kept */
  | { type: "reset" }
  /** pauses and shows the moment at the end of a tick of the run, everywhere */
  | { type: "seek"; tick: number }
  /** pauses and shows the moment of the decision before or after the shown one */
  | { type: "seek-step"; by: 1 | -1 }
  /** plays what was recorded on from the shown moment up to now; changes nothing */
  | { type: "play" }
  /** shows the newest moment again */
  | { type: "now" }
  /** forgets what came after the shown moment and runs on from it */
  | { type: "run-here" }
  | LoadRun
  | RestoreRun
  /** the tab has noted, or could not note, the key of `run-key` */
  | { type: "run-key-noted"; ok: boolean }
  /** gives up opening a run, which is then answered as cancelled */
  | { type: "cancel-load"; id: number }
  /** asks for the run so far, answered by `run-saved`; one longer than a document may be is not written */
  | { type: "save-run"; id: number }
  | AddGhost
  /** takes a ghost out of the race */
  | { type: "remove-ghost"; id: number }
  /** judges the run by a maze of a challenge, answered by `judgement` with the same id; null: by none */
  | { type: "judge"; id: number; attempt: { challenge: ChallengeDocument; maze: number } | null }
  | { type: "speed"; speed: Speed }
  | { type: "driver"; driver: DriverName }
  /** the same, where the run has not begun and nobody else was chosen */
  | { type: "offer-driver"; driver: DriverName }
  | { type: "hold"; key: DriveKey }
  | { type: "remote-open"; session: RemoteSession | null; fresh: boolean }
  | { type: "remote-close" }
  | { type: "remote-clear" }
  /** runs a program, or commands at given ticks, beside the robot and answers with the digest */
  | {
      type: "digest";
      maze: MazeDocument;
      driver: ProgramDocument | readonly TimedCommand[];
      ticks: number;
    };

/** Which moment of the run is shown: the newest, an earlier one, or one after the other on the way to now. */
export type RunView = "now" | "past" | "playing";

/** What is drawn: the snapshot of the shown moment, and what the trail up to it gained since the last frame. */
export interface Frame {
  snapshot: Snapshot;
  /** how far the running manoeuvre is at the shown moment; null when none runs */
  progress: Progress | null;
  view: RunView;
  /** the run's last tick; the shown one is the snapshot's */
  nowTick: number;
  /** ticks up to the shown moment in which a script let the robot wait */
  waited: number;
  /** who drives the newest moment; the driver of the shown one is the snapshot's */
  nowDriver: DriverName;
  /** rises whenever inputs came to the run or were forgotten: then a run saved before is out of date */
  revision: number;
  /**
   * Corners of the trail since the last frame, x and y by turns, in units; its end is the pose. Packed where
   * they cross to the page: a jump brings 40,000 numbers, and as many objects cost 15 ms of clearing up.
   */
  corners: readonly number[] | Float64Array;
  /** where the robot's centre was at bumps since the last frame, x and y by turns, in units */
  bumps: number[];
  /** true when the trail and the bumps begin anew: forget those drawn so far */
  trailReset: boolean;
  /** the ghosts of a race at the displayed tick; absent where no race is on */
  ghosts?: readonly GhostPose[];
}

/** A ghost of a race: its letter, its centre in units and its heading in degrees. */
export interface GhostPose {
  badge: string;
  x: number;
  y: number;
  heading: number;
}

/** What one run of a race took to the goal, or to its end where it reached none. */
export interface Finish {
  /** null: the run ended before it reached the goal */
  goalTick: number | null;
  /** up to the goal or the end */
  bumps: number;
  driver: DriverName;
  /** lines of the program that do something */
  lines: number;
}

/** The answer to `add-ghost`: what the run took; or why it cannot be repeated. */
export type AddedGhost =
  | { ok: true; finish: Finish }
  /** no problems: the simulator broke, or the race has no room */
  | { ok: false; problems: FieldProblem[] };

/** Something worth telling in words. `line` is null when no program line was in charge. */
export interface RunEvent {
  kind: "bump" | "goal";
  tick: number;
  pose: Pose;
  line: LineRef | null;
  driver: DriverName;
  /** bumps so far, this one included */
  bumps: number;
  /** how it came to a bump; null for the goal */
  cause: BumpCause | null;
  /**
   * why it happened; null for the goal, for a bump by hand, and for those of a line whose bump was
   * explained before
   */
  diagnosis: Diagnosis | null;
  /**
   * the program that drove, where the page has something to explain of it: it may have been edited there while this
   * was on its way; null for a bump that pauses no run
   */
  program: ProgramDocument | null;
}

/** Connection of the page to the relay and of scripts to the robot. */
export type RemoteStatus =
  | { kind: "off" }
  | { kind: "connecting" }
  | { kind: "waiting" }
  /** `heardAt`: milliseconds since 1970, since worker and page count their own time from different starts */
  | { kind: "connected"; client: string; heardAt: number }
  /** not connected; the page tries again by itself, unless the service answered that it has no robot for it */
  | { kind: "lost"; reason: RemoteTrouble }
  /** the session is gone for this page */
  | { kind: "over"; reason: RemoteTrouble };

/** Why there is no connection: a close code by its name, or what went wrong without one. */
export type RemoteTrouble =
  | keyof typeof closeReasons
  | Exclude<RegistrationError["code"], "noAnswer">
  /** the connection broke without a close code, or nothing answers */
  | "lineLost";

/** A command for this page's robot, and what became of it. */
export interface ListedCommand extends Omit<CommandRecord, "reason"> {
  /** why this page ended it early */
  reason: CancelReason | null;
  /** ms that it was given to start within */
  ttl: number;
}

/** A script as the panel shows it. */
export interface ListedScript extends Omit<ScriptView, "silentMs"> {
  /** milliseconds since 1970; null: not lately */
  heardAt: number | null;
}

export interface RemoteView {
  status: RemoteStatus;
  session: RemoteSession | null;
  /** newest first, at most 100 */
  commands: ListedCommand[];
  scripts: ListedScript[];
  /** remote driving is paused by its owner */
  isPaused: boolean;
}

/** The answer to `load-run`: the documents that the run ended with; or why nothing was loaded. */
export type LoadedRun =
  | { ok: true; maze: MazeDocument; program: ProgramDocument }
  /** it cannot be repeated */
  | { ok: false; reason: "refused"; problems: FieldProblem[] }
  /** the stored run is of another project, or there is none */
  | { ok: false; reason: "other-project" | "not-stored" }
  /** given up for something else, or the simulator broke, which is told as a fault */
  | { ok: false; reason: "cancelled" | "fault" };

/** The answer to `save-run`: the text of the document and its ticks, or why there is none. */
export type SavedRun =
  | { ok: true; text: string; ticks: number }
  | Extract<WrittenRun, { ok: false }>;

export type FromWorker =
  /**
   * at the calm rate of the panels, and at once when something was decided, with what the timeline gained
   * or lost: one message, so that the page draws both in one go
   */
  | { type: "frame"; frame: Frame; timeline: TimelineDelta | null }
  /** every frame, for a page that draws the stage by itself; `frame` comes beside it */
  | { type: "picture"; frame: Frame }
  /** the camera follows the robot: scroll the stage there */
  | { type: "stage-scroll-to"; scroll: Scroll }
  /**
   * what happened after the end of this tick is no part of the run any more, which goes on from there in
   * another way; -1: it is another run. Comes before the frames and moments of the new way.
   */
  | { type: "truncated"; after: number }
  | { type: "event"; event: RunEvent }
  /** why the program's robot does not get to the goal; sent once, and once more when the time is over */
  | { type: "diagnosed"; program: ProgramDocument; diagnosis: Diagnosis }
  /** how the attempt stands by the newest `judge`, each time that this changes; open to begin with */
  | { type: "judgement"; id: number; judgement: Judgement }
  /** the maze of the shown moment where it is not the newest one; null when it is */
  | { type: "shown-maze"; maze: MazeDocument | null }
  /**
   * where a reload finds the run; null: this device cannot store it, and a reload begins at the start. Answered by
   * `run-key-noted`
   */
  | { type: "run-key"; key: string | null }
  | { type: "run-saved"; id: number; saved: SavedRun }
  /** how much of a long run is opened, from 0 to 1 */
  | { type: "run-loading"; id: number; part: number }
  | { type: "run-loaded"; id: number; loaded: LoadedRun }
  | { type: "ghost-added"; id: number; added: AddedGhost }
  | { type: "remote"; remote: RemoteView }
  | { type: "digest"; digest: string }
  | { type: "fault"; reason: string };
