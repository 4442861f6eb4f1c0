/**
 * What a run was, for the eye: driver or which line drove from when on, and what happened when.
 *
 * Packed into typed arrays, because an hour has 216,000 ticks and a program may choose anew on each of
 * them. Neighbouring stretches shorter than a tenth of a second are one, "mixed", and events of one
 * kind closer than that are one mark; where a run of many hours has too many all the same, that
 * shortest time doubles.
 *
 * The end that records calls `drives`, `happened` and `truncateAfter`; what changed crosses to another
 * thread by `take` and `merge`.
 */
import type { LineRef } from "@corridor/protocol";
import { CommandLog, type CommandDelta } from "./command-log.ts";
import { GrowingArray } from "./growing-array.ts";

/** TimelineDriver drove: a hand, a script, a program's line; "mixed" where they changed too fast to tell. */
export type TimelineDriver = "me" | "remote" | "mixed" | LineRef;

/** How the robot turned. */
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

/** Something that happened, at the end of tick `tick`; `driver` drove. */
export type TimelineEvent = { tick: number; driver: TimelineDriver } & (
  | { kind: "turn"; turn: TurnName }
  | { kind: "bump" }
  | { kind: "goal" }
  | { kind: "edit"; what: "maze" | "program" }
);

/** What a timeline gained or lost since the last `take`; typed arrays, cheap to send. */
export interface TimelineDelta {
  /** stretches that stay as they were; those after them are replaced */
  unchangedSegments: number;
  ticks: Int32Array<ArrayBuffer>;
  drivers: Int16Array<ArrayBuffer>;
  /** events that stay as they were; those after them are replaced */
  unchangedEvents: number;
  eventTicks: Int32Array<ArrayBuffer>;
  eventCodes: Int16Array<ArrayBuffer>;
  eventDrivers: Int16Array<ArrayBuffer>;
  /** null where nothing changed in them */
  commands: CommandDelta | null;
  endTick: number;
}

/** Codes of driver drove: a line by its index, the others below 0. */
const OTHERWISE = -1;
const ME = -2;
const REMOTE = -3;
const MIXED = -4;

/** Codes of events: turns by their index in `turnNames`, then the others. */
const BUMP = 16;
const GOAL = 17;
const EDITED_MAZE = 18;
const EDITED_PROGRAM = 19;

/** A tenth of a second: shorter stretches, and shorter gaps between events of one kind, are not told apart. */
const MIN_TICKS = 6;
/** Above so many stretches or events, the shortest time doubles: more than a screen has pixels by far. */
const MAX_ENTRIES = 50_000;

export class Timeline {
  /** the commands of scripts, and the waits between them */
  readonly commands = new CommandLog();
  readonly #ticks = new GrowingArray("int32");
  readonly #drivers = new GrowingArray("int16");
  readonly #eventTicks = new GrowingArray("int32");
  readonly #eventCodes = new GrowingArray("int16");
  readonly #eventDrivers = new GrowingArray("int16");
  #endTick = 0;
  /** as they were at the last `take`: what was cut since then leaves nothing new behind */
  #sentEndTick = -1;
  #sentSegments = 0;
  #sentEvents = 0;
  #minTicks = MIN_TICKS;
  /** stretches and events that are as they were at the last `take` */
  #unchangedSegments = 0;
  #unchangedEvents = 0;

  /** Stretches, in the order of time; each lasts until the next begins, the last until `endTick`. */
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

  /** Bytes held. */
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

  /** Tick at whose end stretch `index` begins: its driver moves the robot from the tick after it on. */
  tickOf(index: number): number {
    return this.#ticks.at(index);
  }

  /** TimelineDriver drove in stretch `index`. */
  driverOf(index: number): TimelineDriver {
    return driverOfCode(this.#drivers.at(index));
  }

  /** Index of the stretch that holds the moment at the end of `tick`; -1 before the first one. */
  segmentAt(tick: number): number {
    return this.#ticks.countUpTo(tick) - 1;
  }

  /** Event `index`, in the order of time. */
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

  /** How many events happened up to the end of `tick`: the index of the first one after it. */
  eventsUpTo(tick: number): number {
    return this.#eventTicks.countUpTo(tick);
  }

  /** From the end of `tick` on, `driver` drives. */
  recordDriver(tick: number, driver: Exclude<TimelineDriver, "mixed">): void {
    const code = codeOfDriver(driver);
    const last = this.#ticks.length - 1;
    if (last >= 0 && this.#drivers.at(last) === code) return;
    // Nobody drove in a stretch without a tick.
    const from = last >= 0 && this.#ticks.at(last) === tick ? last : last + 1;
    this.#truncateSegments(from);
    const before = this.#ticks.length - 1;
    if (before >= 0 && this.#drivers.at(before) === code) return;
    this.#mergeShort(tick);
    this.#ticks.push(tick);
    this.#drivers.push(code);
    if (this.#ticks.length > MAX_ENTRIES) this.#coarsen();
  }

  /** Notes an event; one soon after another of its kind by the same driver is the same mark. */
  recordEvent(event: TimelineEvent): void {
    const code = codeOfEvent(event);
    const driver = codeOfDriver(event.driver);
    // Each edit has its own mark, unless there are more of them than marks: a file may bring 100,000.
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

  /** The run has gone on to this tick. */
  advanceTo(tick: number): void {
    this.#endTick = tick;
  }

  /** Forgets what came after the end of `tick`, and what was decided there: another way follows. */
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

  /** What changed since the last call; null when nothing did. */
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

  /** Takes in what another timeline gained or lost. */
  applyDelta(delta: TimelineDelta): void {
    this.#ticks.replaceFrom(delta.unchangedSegments, delta.ticks);
    this.#drivers.replaceFrom(delta.unchangedSegments, delta.drivers);
    this.#eventTicks.replaceFrom(delta.unchangedEvents, delta.eventTicks);
    this.#eventCodes.replaceFrom(delta.unchangedEvents, delta.eventCodes);
    this.#eventDrivers.replaceFrom(delta.unchangedEvents, delta.eventDrivers);
    if (delta.commands !== null) this.commands.applyDelta(delta.commands);
    this.#endTick = delta.endTick;
  }

  /** The last stretch ends at `tick`: where it and the one before it were short, they are one. */
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

  /** Doubles the shortest time and divides everything anew. */
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
