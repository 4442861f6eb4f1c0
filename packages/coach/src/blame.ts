/**
 * Which line led a failed attempt astray, and the numbers that show it: data only, the page makes the
 * sentences.
 */
import type { LineRef, PlainAction, SensorName } from "@corridor/protocol";
import type { Side } from "./advice.ts";
import type { LoopNotice } from "./loop-watch.ts";

/** The line was true, but one above it decided first; moved above that one, the program passes. */
export interface Overruled {
  kind: "overruled";
  line: number;
  above: number;
  tick: number;
  /** what the line asks, and what it read */
  sensor: SensorName;
  reading: number;
}

/** The line asks for more than a number that every reading exceeds: it was meant in other units. */
export interface AlwaysTrue {
  kind: "always-true";
  line: number;
  sensor: SensorName;
  number: number;
  /** units: no reading is below */
  nearest: number;
}

/** A delayed turn that began too near to the wall ahead. */
export interface NoRoom {
  kind: "no-room";
  line: LineRef;
  action: PlainAction;
  /** the reading ahead when it began, and what driving on takes, both from the robot's middle */
  front: number;
  needs: number;
}

/** A turn on the spot at the edge of an opening; delayed it gets past the place. */
export interface EarlyTurn {
  kind: "early-turn";
  line: number;
  action: PlainAction;
  tick: number;
  drivesOn: number;
}

/** A turn towards the nearer wall although another way was open. */
export interface WallTurn {
  kind: "wall-turn";
  line: LineRef;
  action: PlainAction;
  tick: number;
  side: Side;
  /** the reading on the side that it turned to */
  reading: number;
  /** the way that was open */
  open: "front" | Side;
  free: number;
  /** whether no line turns to the side that was open */
  isMissing: boolean;
}

/** One line drives back and another forward, over and over at the same place. */
export interface Undoing {
  kind: "undoing";
  line: number;
  other: LineRef;
  /** the reading ahead at that place */
  front: number;
}

/** A side was open and no line turns to it. */
export interface NoTurn {
  kind: "no-turn";
  side: Side;
  tick: number;
  reading: number;
}

/** The robot got nowhere; nothing better is known than what was seen. */
export interface GotNowhere {
  kind: "nowhere";
  notice: LoopNotice;
}

export type Blame =
  | Overruled
  | AlwaysTrue
  | NoRoom
  | EarlyTurn
  | WallTurn
  | Undoing
  | NoTurn
  | GotNowhere;
