/** Messages to the load process (jobs) and its replies. */
import type { PeerName } from "../peers/peer.ts";

export interface OpenJob {
  kind: "open";
  peer: PeerName;
  pages: string;
  readers: string;
  robots: number;
  scripts: number;
  /** default: 0 */
  viewers?: number;
  /** default: false */
  isBusy?: boolean;
  /** default: null */
  ros?: readonly string[] | null;
  /** default: false */
  drives?: boolean;
}

/** Pages send snapshots and scripts send commands, both at a steady rate. */
export interface PacedJob {
  kind: "paced";
  fleet: number;
  /** snapshots per robot */
  snapshotsPerSecond: number;
  /** commands of all scripts */
  commandsPerSecond: number;
  seconds: number;
  /** processes whose processor time is measured */
  pids: readonly number[];
}

/** Messages at the maximum rate, with a constant number in flight. */
export interface FloodJob {
  kind: "flood";
  of: "snapshots" | "commands";
  fleet: number;
  inFlight: number;
  seconds: number;
  pids: readonly number[];
}

export interface CloseJob {
  kind: "close";
  fleet: number;
}

export type Job = OpenJob | PacedJob | FloodJob | CloseJob;

/** The result of a paced or flood job. Times are in milliseconds. */
export interface LoadResult {
  seconds: number;
  /** number of processed snapshots or answered commands */
  done: number;
  /** number of snapshots that readers received */
  forwarded: number;
  /** processor time of each process */
  processorMs: number[];
  /** from sending a snapshot at the page until its reader receives it */
  latencies: number[];
  /** from a command to its answer */
  answers: number[];
  /** from a command to its `started` event */
  starts: number[];
}

export interface LoadReply {
  fleet: number;
  result: LoadResult | null;
}
