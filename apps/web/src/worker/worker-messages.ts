/**
 * Everything that crosses between the page's main thread and the simulator worker, and nothing else.
 * Documents were parsed and checked before they are sent; both ends are our own code.
 */
import type { RegistrationError } from "@corridor/client/host";
import type {
  closeReasons,
  CommandRecord,
  DriverName,
  LineRef,
  Pose,
  Snapshot,
  TimedCommand,
} from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { CancelReason } from "../drivers/cancel-reason.ts";

/** How many simulated seconds pass in one second; "max" is as many as the machine gives. */
export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16, "max"] as const;
export type Speed = (typeof speeds)[number];

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

export type ToWorker =
  /** the first message: what the page starts with */
  | { type: "load"; maze: MazeDocument; program: ProgramDocument }
  /** the maze changed under the robot: it stays where it is, or goes to its start where it no longer fits */
  | { type: "edit-maze"; maze: MazeDocument }
  | { type: "edit-program"; program: ProgramDocument }
  | { type: "run" }
  | { type: "pause" }
  /** takes one decision (one tick, or one whole manoeuvre), then pauses */
  | { type: "step" }
  /** robot to start, everything else kept */
  | { type: "reset" }
  | { type: "speed"; speed: Speed }
  | { type: "driver"; driver: DriverName }
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

/** What is drawn: the newest snapshot, and what the trail gained since the last frame. */
export interface Frame {
  snapshot: Snapshot;
  /** corners of the trail since the last frame, x and y by turns, in units; its end is the pose */
  corners: number[];
  /** true when the robot was put back to its start: forget the trail drawn so far */
  trailReset: boolean;
}

/** Something worth telling in words. `line` is null when no program line was in charge. */
export interface Moment {
  kind: "bump" | "goal";
  tick: number;
  pose: Pose;
  line: LineRef | null;
  driver: DriverName;
  /** bumps so far, this one included */
  bumps: number;
}

/** Connection of the page to the relay and of scripts to the robot. */
export type RemoteStatus =
  | { kind: "off" }
  | { kind: "connecting" }
  | { kind: "waiting" }
  /** `heardAt`: milliseconds since 1970, since worker and page count their own time from different starts */
  | { kind: "connected"; client: string; heardAt: number }
  /** not connected; where there is a session, it is tried again by itself */
  | { kind: "lost"; reason: RemoteTrouble }
  /** the session is gone for this page */
  | { kind: "over"; reason: RemoteTrouble };

/** Why there is no connection: a close code by its name, or what went wrong without one. */
export type RemoteTrouble =
  | keyof typeof closeReasons
  | RegistrationError["code"]
  /** the line broke without a word */
  | "lineLost";

/** A command that this page was given, and what it made of it. */
export type ListedCommand = Omit<CommandRecord, "reason"> & { reason: CancelReason | null };

export interface RemoteView {
  status: RemoteStatus;
  session: RemoteSession | null;
  /** newest first, at most 100 */
  commands: ListedCommand[];
}

export type FromWorker =
  | { type: "frame"; frame: Frame }
  | { type: "moment"; moment: Moment }
  | { type: "remote"; remote: RemoteView }
  | { type: "digest"; digest: string }
  | { type: "fault"; reason: string };
