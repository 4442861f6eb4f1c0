/**
 * The timeline of a run for display: segments with one driver or program line, and events.
 *
 * Data is packed into typed arrays, because an hour has 216,000 ticks and a program can change its
 * line on each of them. Adjacent segments shorter than a tenth of a second merge into a "mixed"
 * segment. Events of one kind within that time merge into one. If the number of entries exceeds the
 * maximum, this minimum time doubles.
 *
 * The recording thread calls `recordDriver`, `recordEvent` and `truncateAfter`. Another thread
 * receives changes by `takeDelta` and `applyDelta`.
 */
import type { LineRef } from "@corridor/protocol";
import { CommandLog, type CommandDelta } from "./command-log.ts";
import { GrowingArray } from "./growing-array.ts";

/**
 * Driver of a segment: manual ("me"), a script ("remote"), or a program line; "mixed" for fast
 * changes.
 */
export type TimelineDriver = "me" | "remote" | "mixed" | LineRef;

/** Kinds of turns. */
export const turnNames = [
  "left 90",
  "right 90",
  "turn 180",
  "delayed left 90",
  "delayed right 90",
  "turn left",
  "turn right",
] as const;
export type TurnName = (typeof turnNames)[number];

/** An event at the end of tick `tick`, and the driver at that time. */
export type TimelineEvent = { tick: number; driver: TimelineDriver } & (
  | { kind: "turn"; turn: TurnName }
  | { kind: "bump" }
  | { kind: "goal" }
  | { kind: "edit"; what: "maze" | "program" }
);

/** Changes of a timeline since the last `takeDelta`, in typed arrays that are cheap to send. */
export interface TimelineDelta {
  /** number of unchanged segments; the segments of the delta replace the following ones */
  unchangedSegments: number;
  ticks: Int32Array<ArrayBuffer>;
  drivers: Int16Array<ArrayBuffer>;
  /** number of unchanged events; the events of the delta replace the following ones */
  unchangedEvents: number;
  eventTicks: Int32Array<ArrayBuffer>;
  eventCodes: Int16Array<ArrayBuffer>;
  eventDrivers: Int16Array<ArrayBuffer>;
  /** null if the commands did not change */
  commands: CommandDelta | null;
  endTick: number;
}

/** Codes of drivers: a line by its index, the others below 0. */
const OTHERWISE = -1;
const ME = -2;
const REMOTE = -3;
const MIXED = -4;

/** Codes of events: a turn by its index in `turnNames`, then the others. */
const BUMP = 16;
const GOAL = 17;
const EDITED_MAZE = 18;
const EDITED_PROGRAM = 19;

/** Minimum length of a segment, and minimum gap between events of one kind: a tenth of a second. */
const MIN_TICKS = 6;
/** Maximum number of segments or events, far more than a screen has pixels. */
const MAX_ENTRIES = 50_000;

export class Timeline {
  /** the commands of scripts, and the waiting times between them */
  readonly commands = new CommandLog();
  readonly #ticks = new GrowingArray("int32");
  readonly #drivers = new GrowingArray("int16");
  readonly #eventTicks = new GrowingArray("int32");
  readonly #eventCodes = new GrowingArray("int16");
  readonly #eventDrivers = new GrowingArray("int16");
  #endTick = 0;
  /** values at the last `takeDelta`, to detect a truncation without new entries */
  #sentEndTick = -1;
  #sentSegments = 0;
  #sentEvents = 0;
  #minTicks = MIN_TICKS;
  /** number of segments and events unchanged since the last `takeDelta` */
  #unchangedSegments = 0;
  #unchangedEvents = 0;

  /** Number of segments in time order. Each lasts until the next one, the last until `endTick`. */
  get segmentCount(): number {
    return this.#ticks.length;
  }

  get eventCount(): number {
    return this.#eventTicks.length;
  }

  /** The last tick of the run. */
  get endTick(): number {
    return this.#endTick;
  }

  /** Allocated bytes. */
  get byteLength(): number {
    return (
      this.#ticks.byteLength +
      this.#drivers.byteLength +
      this.#eventTicks.byteLength +
      this.#eventCodes.byteLength +
      this.#eventDrivers.byteLength +
      this.commands.byteLength
    );
  }

  /** Tick at whose end segment `index` starts. Its driver moves the robot from the next tick on. */
  tickOf(index: number): number {
    return this.#ticks.at(index);
  }

  /** Driver of segment `index`. */
  driverOf(index: number): TimelineDriver {
    return driverOfCode(this.#drivers.at(index));
  }

  /** Index of the segment that contains the end of `tick`; -1 before the first segment. */
  segmentAt(tick: number): number {
    return this.#ticks.countUpTo(tick) - 1;
  }

  /** Returns event `index`, in time order. */
  eventAt(index: number): TimelineEvent {
    const tick = this.#eventTicks.at(index);
    const code = this.#eventCodes.at(index);
    const driver = driverOfCode(this.#eventDrivers.at(index));
    if (code === BUMP) return { kind: "bump", tick, driver };
    if (code === GOAL) return { kind: "goal", tick, driver };
    if (code === EDITED_MAZE) return { kind: "edit", what: "maze", tick, driver };
    if (code === EDITED_PROGRAM) return { kind: "edit", what: "program", tick, driver };
    const turn = turnNames[code];
    if (turn === undefined) throw new RangeError(`The timeline has no event ${index}.`);
    return { kind: "turn", turn, tick, driver };
  }

  /** Number of events up to the end of `tick`, which is the index of the first event after it. */
  eventsUpTo(tick: number): number {
    return this.#eventTicks.countUpTo(tick);
  }

  /** Records that `driver` drives from the end of `tick` on. */
  recordDriver(tick: number, driver: Exclude<TimelineDriver, "mixed">): void {
    const code = codeOfDriver(driver);
    const last = this.#ticks.length - 1;
    if (last >= 0 && this.#drivers.at(last) === code) return;
    // A segment without a tick is replaced.
    const from = last >= 0 && this.#ticks.at(last) === tick ? last : last + 1;
    this.#truncateSegments(from);
    const before = this.#ticks.length - 1;
    if (before >= 0 && this.#drivers.at(before) === code) return;
    this.#mergeShort(tick);
    this.#ticks.push(tick);
    this.#drivers.push(code);
    if (this.#ticks.length > MAX_ENTRIES) this.#coarsen();
  }

  /**
   * Records an event. Merges it with an event of the same kind and driver within the minimum gap.
   */
  recordEvent(event: TimelineEvent): void {
    const code = codeOfEvent(event);
    const driver = codeOfDriver(event.driver);
    // Edits merge only after the minimum gap has doubled: a file can contain 100,000 edits.
    const isEditApart = event.kind === "edit" && this.#minTicks === MIN_TICKS;
    const isSingle = event.kind === "goal" || isEditApart;
    const last = this.#eventTicks.length - 1;
    for (let at = last; at >= 0 && event.tick - this.#eventTicks.at(at) < this.#minTicks; at--) {
      if (this.#eventCodes.at(at) !== code) continue;
      if (this.#eventDrivers.at(at) !== driver) continue;
      if (isSingle && this.#eventTicks.at(at) !== event.tick) continue;
      return;
    }
    this.#eventTicks.push(event.tick);
    this.#eventCodes.push(code);
    this.#eventDrivers.push(driver);
    if (this.#eventTicks.length > MAX_ENTRIES) this.#coarsen();
  }

  /** Sets the last tick of the run. */
  advanceTo(tick: number): void {
    this.#endTick = tick;
  }

  /**
   * Deletes entries after the end of `tick`, and decisions at that tick, because the run changes
   * there.
   */
  truncateAfter(tick: number): void {
    this.#truncateSegments(this.#ticks.countUpTo(tick - 1));
    let events = this.eventsUpTo(tick);
    while (this.#eventTicks.at(events - 1) === tick && isTurn(this.#eventCodes.at(events - 1))) {
      events--;
    }
    this.#truncateEvents(events);
    this.commands.truncateAfter(tick);
    this.#endTick = tick;
  }

  /** Returns the changes since the last call, or null. */
  takeDelta(): TimelineDelta | null {
    const commands = this.commands.takeDelta();
    const isSame =
      commands === null &&
      this.#unchangedSegments === this.#ticks.length &&
      this.#unchangedEvents === this.#eventTicks.length &&
      this.#sentSegments === this.#ticks.length &&
      this.#sentEvents === this.#eventTicks.length &&
      this.#sentEndTick === this.#endTick;
    if (isSame) return null;
    const delta: TimelineDelta = {
      unchangedSegments: this.#unchangedSegments,
      ticks: this.#ticks.copyFrom(this.#unchangedSegments),
      drivers: this.#drivers.copyFrom(this.#unchangedSegments),
      unchangedEvents: this.#unchangedEvents,
      eventTicks: this.#eventTicks.copyFrom(this.#unchangedEvents),
      eventCodes: this.#eventCodes.copyFrom(this.#unchangedEvents),
      eventDrivers: this.#eventDrivers.copyFrom(this.#unchangedEvents),
      commands,
      endTick: this.#endTick,
    };
    this.#unchangedSegments = this.#ticks.length;
    this.#unchangedEvents = this.#eventTicks.length;
    this.#sentSegments = this.#ticks.length;
    this.#sentEvents = this.#eventTicks.length;
    this.#sentEndTick = this.#endTick;
    return delta;
  }

  /** Applies the changes of another timeline. */
  applyDelta(delta: TimelineDelta): void {
    this.#ticks.replaceFrom(delta.unchangedSegments, delta.ticks);
    this.#drivers.replaceFrom(delta.unchangedSegments, delta.drivers);
    this.#eventTicks.replaceFrom(delta.unchangedEvents, delta.eventTicks);
    this.#eventCodes.replaceFrom(delta.unchangedEvents, delta.eventCodes);
    this.#eventDrivers.replaceFrom(delta.unchangedEvents, delta.eventDrivers);
    if (delta.commands !== null) this.commands.applyDelta(delta.commands);
    this.#endTick = delta.endTick;
  }

  /** Merges the last segment, which ends at `tick`, with the previous one if both are short. */
  #mergeShort(tick: number): void {
    const last = this.#ticks.length - 1;
    if (last < 1 || tick - this.#ticks.at(last) >= this.#minTicks) return;
    const before = last - 1;
    const isMixed = this.#drivers.at(before) === MIXED;
    if (!isMixed && this.#ticks.at(last) - this.#ticks.at(before) >= this.#minTicks) return;
    this.#truncateSegments(last);
    if (isMixed) return;
    this.#unchangedSegments = Math.min(this.#unchangedSegments, before);
    this.#drivers.set(before, MIXED);
  }

  /** Doubles the minimum time and merges all entries again. */
  #coarsen(): void {
    this.#minTicks *= 2;
    const ticks = this.#ticks.copyFrom(0);
    const drivers = this.#drivers.copyFrom(0);
    this.#truncateSegments(0);
    for (const [index, tick] of ticks.entries()) {
      this.#mergeShort(tick);
      this.#ticks.push(tick);
      this.#drivers.push(drivers[index] ?? MIXED);
    }
    const events = Array.from({ length: this.eventCount }, (_, index) => this.eventAt(index));
    this.#truncateEvents(0);
    for (const event of events) this.recordEvent(event);
  }

  #truncateSegments(length: number): void {
    this.#ticks.truncate(length);
    this.#drivers.truncate(length);
    this.#unchangedSegments = Math.min(this.#unchangedSegments, length);
  }

  #truncateEvents(length: number): void {
    this.#eventTicks.truncate(length);
    this.#eventCodes.truncate(length);
    this.#eventDrivers.truncate(length);
    this.#unchangedEvents = Math.min(this.#unchangedEvents, length);
  }
}

function isTurn(code: number): boolean {
  return code < turnNames.length;
}

function codeOfDriver(driver: TimelineDriver): number {
  switch (driver) {
    case "default":
      return OTHERWISE;
    case "me":
      return ME;
    case "remote":
      return REMOTE;
    case "mixed":
      return MIXED;
    default:
      return driver;
  }
}

function driverOfCode(code: number): TimelineDriver {
  if (code === OTHERWISE) return "default";
  if (code === ME) return "me";
  if (code === REMOTE) return "remote";
  return code === MIXED || Number.isNaN(code) ? "mixed" : code;
}

function codeOfEvent(event: TimelineEvent): number {
  switch (event.kind) {
    case "turn":
      return turnNames.indexOf(event.turn);
    case "bump":
      return BUMP;
    case "goal":
      return GOAL;
    case "edit":
      return event.what === "maze" ? EDITED_MAZE : EDITED_PROGRAM;
  }
}
