/**
 * What relays that serve the same robot tell each other: a line for each robot. Nothing on it is needed
 * for a command to be neither lost nor doubled; the store alone sees to that. Every form of it passes
 * `testing/switchboard.cases.ts`; see docs/adr/0010-several-relays.md.
 */
import type { CommandRecord, RecallCause } from "@corridor/protocol";
import type { CarriedSnapshot } from "../sessions/carried-snapshot.ts";
import type { Scripts } from "../sessions/driver-roster.ts";
import type { TermedRecord } from "../store/session-store.ts";

/** What one step of the store has changed. */
export interface Step {
  /** a command that was accepted and waits */
  added: TermedRecord | null;
  /** new states, for whoever reads */
  changed: CommandRecord[];
  /** which of them a relay has ended, for the page to show */
  ended: TermedRecord[];
}

/** Whatever else there is to say. */
export type News =
  /** the newest, many times a second; for those who said that they are here */
  | { kind: "snapshot"; snapshot: CarriedSnapshot }
  /** a page has taken the robot at another relay */
  | { kind: "page"; epoch: number; name: string }
  /** that page is away, or its relay is; whether it had said goodbye, so that all it had begun was heard */
  | { kind: "page-left"; epoch: number; saidGoodbye: boolean }
  /** this relay gave no sign of life for so long that the others took its pages for away */
  | { kind: "lapsed" }
  /** another relay has the robot on its line, and these scripts; `asks` for the newest snapshot at once */
  | { kind: "here"; from: string; scripts: Scripts; asks: boolean }
  /** a page has come to another relay: the one with this epoch is asked to give the robot up */
  | { kind: "yield"; epoch: number }
  /** it has told its relay all that it has begun, and begins nothing any more */
  | { kind: "yielded"; epoch: number }
  /** the page is asked to end this command */
  | { kind: "cancel"; seq: number; why: RecallCause }
  /** keys or who is away were changed, or may have been: the store has what counts */
  | { kind: "keys" }
  /** the robot is in another maze, which the store has */
  | { kind: "maze"; version: string }
  /** the robot was forgotten */
  | { kind: "over" };

export interface Ears {
  /** A step of a relay, this one included: everyone on the line hears all steps in the same order. */
  stepped(step: Step, isOwn: boolean): void;
  /** Steps may not have been heard. */
  missed(): void;
  /** News of another relay. */
  heard(news: News): void;
}

export interface Line {
  /** Passes on what a step of this relay has changed, unless the store has done so. */
  stepped(step: Step): void;
  tell(news: News): void;
  /** What was told so far goes before the next step of the store. */
  hurry(): void;
  leave(): void;
}

export interface Switchboard {
  /**
   * Puts this relay on a robot's line. Where a page has the robot at another relay, that is heard
   * before this returns.
   */
  join(robot: string, ears: Ears): Promise<Line>;
  close(): Promise<void>;
}
