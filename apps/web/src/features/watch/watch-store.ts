/** The state of a viewer's page, and the name of the sentence that describes it. */
import type { WatchStatus } from "@corridor/client/watch";
import type { MazeDocument } from "@corridor/maze";
import { closeReasons, type DriverName, type Snapshot } from "@corridor/protocol";
import { createStore } from "zustand/vanilla";
import type { Visit } from "./watch-address.ts";

export interface WatchState {
  visit: Visit;
  line: WatchStatus & {
    /** whether there was a connection before, so that this is a reconnection */
    isAgain: boolean;
  };
  snapshot: Snapshot | null;
  /** the last tick at which a script's command ran; null if none has since Remote drives */
  scriptTick: number | null;
  /** whether a script has marked cells of the maze */
  hasMarks: boolean;
  /** false: the viewer has hidden the marks */
  showsMarks: boolean;
  /** null: the maze is unknown; undefined: not received yet */
  maze: MazeDocument | null | undefined;
  /** whether the worker failed */
  isBroken: boolean;
}

export function createWatchStore(visit: Visit) {
  return createStore<WatchState>()(() => ({ ...nothingYet, visit, showsMarks: true }));
}
export type WatchStore = ReturnType<typeof createWatchStore>;

/** The state before any message about a robot. */
export const nothingYet: Omit<WatchState, "visit" | "showsMarks"> = {
  line: { kind: "connecting", isAgain: false },
  snapshot: null,
  scriptTick: null,
  hasMarks: false,
  maze: undefined,
  isBroken: false,
};

/** The state of the robot, as the name of its sentence. */
export type RobotState = "connecting" | "waiting" | "running" | "paused" | "gone" | "lost";

export function robotState({ line, snapshot }: WatchState): RobotState {
  if (line.kind !== "connected") return line.isAgain ? "lost" : "connecting";
  return snapshot === null ? "waiting" : snapshot.state;
}

/**
 * Ticks without a command, half a minute at normal speed, after which the script counts as
 * finished.
 */
const SCRIPT_STAYS = 1800;

/**
 * The state after a snapshot, which contains the running command, but not the connected scripts.
 */
export function seeSnapshot(
  { scriptTick }: Pick<WatchState, "scriptTick">,
  snapshot: Snapshot,
): Pick<WatchState, "snapshot" | "scriptTick"> {
  const { driver, command, tick } = snapshot;
  if (driver !== "remote") return { snapshot, scriptTick: null };
  if (command !== null) return { snapshot, scriptTick: tick };
  const isStill = scriptTick !== null && tick - scriptTick < SCRIPT_STAYS;
  return { snapshot, scriptTick: isStill ? scriptTick : null };
}

/** The driver, as the name of its sentence. */
export function drivenBy({ snapshot, scriptTick }: WatchState): DriverName | "waiting" | null {
  const driver = snapshot?.driver ?? null;
  return driver === "remote" && scriptTick === null ? "waiting" : driver;
}

/** The reason why there is nothing to watch, as the name of its sentences. */
export type Ending = "script" | "broken" | "revoked" | "deleted" | "failed";

/** Null while there is something to watch, or will be. */
export function endingOf({ visit, line, isBroken }: WatchState): Ending | null {
  if (visit.kind !== "watch") return visit.kind;
  if (isBroken) return "failed";
  if (line.kind !== "over") return null;
  const { code } = line.reason;
  const isDeleted = code === closeReasons.noRobot.code || code === closeReasons.over.code;
  return isDeleted ? "deleted" : "revoked";
}
