/** What an onlooker's page knows of the robot, and the sentence that says how it is. */
import type { WatchStatus } from "@corridor/client/watch";
import type { MazeDocument } from "@corridor/maze";
import { closeReasons, type DriverName, type Snapshot } from "@corridor/protocol";
import { createStore } from "zustand/vanilla";
import type { Visit } from "./watch-address.ts";

export interface WatchState {
  visit: Visit;
  line: WatchStatus & {
    /** whether there was a line already, so that this is another one */
    isAgain: boolean;
  };
  snapshot: Snapshot | null;
  /** the tick at which a script's command was last seen to run; null while none was since Remote drives */
  scriptTick: number | null;
  /** null: nobody knows it; undefined: nobody has said so yet */
  maze: MazeDocument | null | undefined;
  /** the worker did not load, or broke */
  isBroken: boolean;
}

export function createWatchStore(visit: Visit) {
  return createStore<WatchState>()(() => ({ ...nothingYet, visit }));
}
export type WatchStore = ReturnType<typeof createWatchStore>;

/** Before anything of a robot is known. */
export const nothingYet: Omit<WatchState, "visit"> = {
  line: { kind: "connecting", isAgain: false },
  snapshot: null,
  scriptTick: null,
  maze: undefined,
  isBroken: false,
};

/** How the robot is, by the name of its sentence. */
export type RobotState = "connecting" | "waiting" | "running" | "paused" | "gone" | "lost";

export function robotState({ line, snapshot }: WatchState): RobotState {
  if (line.kind !== "connected") return line.isAgain ? "lost" : "connecting";
  return snapshot === null ? "waiting" : snapshot.state;
}

/** After so many ticks without a command, half a minute at the usual speed, nobody counts on the script. */
const SCRIPT_STAYS = 1800;

/** What a snapshot changes: it tells of the command that runs, not of the scripts that there are. */
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

/** Who drives, by the name of its sentence. */
export function drivenBy({ snapshot, scriptTick }: WatchState): DriverName | "waiting" | null {
  const driver = snapshot?.driver ?? null;
  return driver === "remote" && scriptTick === null ? "waiting" : driver;
}

/** Why there is nothing to look at, by the name of its sentences. */
export type Ending = "script" | "broken" | "revoked" | "forgotten" | "failed";

/** Null as long as there is something to look at, or will be. */
export function endingOf({ visit, line, isBroken }: WatchState): Ending | null {
  if (visit.kind !== "watch") return visit.kind;
  if (isBroken) return "failed";
  if (line.kind !== "over") return null;
  const { code } = line.reason;
  const isForgotten = code === closeReasons.noRobot.code || code === closeReasons.over.code;
  return isForgotten ? "forgotten" : "revoked";
}
