/** What the load process is asked to do, and what it tells of it. */
import type { ContenderName } from "../contenders/contender.ts";

export interface OpenJob {
  kind: "open";
  contender: ContenderName;
  pages: string;
  readers: string;
  robots: number;
  scripts: number;
  /** default: 0 */
  onlookers?: number;
  /** default: no */
  isBusy?: boolean;
}

/** Pages report at a steady pace, scripts command at another. */
export interface PacedJob {
  kind: "paced";
  fleet: number;
  /** snapshots of each robot */
  aSecond: number;
  /** of all scripts together */
  commandsASecond: number;
  seconds: number;
  /** processes whose time is counted meanwhile */
  pids: readonly number[];
}

/** As many as the contender takes, with so many on their way. */
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

/** What a paced or flooding job saw. Times in ms. */
export interface Seen {
  seconds: number;
  /** snapshots that were taken, or commands that were answered */
  done: number;
  /** snapshots that came to readers */
  passed: number;
  /** processor time of each process */
  processorMs: number[];
  /** from a page to its reader */
  ways: number[];
  /** from a command to its answer */
  answers: number[];
  /** from a command to the news that it has begun */
  beginnings: number[];
}

export interface Answer {
  fleet: number;
  seen: Seen | null;
}
