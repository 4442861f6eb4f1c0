/**
 * What a run was, for the eye: who or which line drove from when on, and what happened when.
 *
 * Packed into typed arrays, because an hour has 216,000 ticks and a program may choose anew on each of
 * them. Neighbouring stretches shorter than a tenth of a second are one, "mixed", and events of one
 * kind closer than that are one mark; where a run of many hours has too many all the same, that
 * shortest time doubles.
 *
 * The end that records calls `drives`, `happened` and `forgetAfter`; what changed crosses to another
 * thread by `take` and `merge`.
 */
import type { LineRef } from "@corridor/protocol";
import { CommandLog, type CommandNews } from "./command-log.ts";
import { GrowingArray } from "./growing-array.ts";

/** Who drove: a hand, a script, a program's line; "mixed" where they changed too fast to tell. */
export type Who = "me" | "remote" | "mixed" | LineRef;

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

/** Something that happened, at the end of tick `tick`; `who` drove. */
export type TimelineEvent = { tick: number; who: Who } & (
  | { kind: "turn"; turn: TurnName }
  | { kind: "bump" }
  | { kind: "goal" }
  | { kind: "edit"; what: "maze" | "program" }
);

/** What a timeline gained or lost since the last `take`; typed arrays, cheap to send. */
export interface TimelineNews {
  /** stretches that stay as they were; those after them are replaced */
  keptStretches: number;
  ticks: Int32Array<ArrayBuffer>;
  whos: Int16Array<ArrayBuffer>;
  /** events that stay as they were; those after them are replaced */
  keptEvents: number;
  eventTicks: Int32Array<ArrayBuffer>;
  eventCodes: Int16Array<ArrayBuffer>;
  eventWhos: Int16Array<ArrayBuffer>;
  /** null where nothing changed in them */
  commands: CommandNews | null;
  endTick: number;
}

/** Codes of who drove: a line by its index, the others below 0. */
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
const SHORTEST = 6;
/** Above so many stretches or events, the shortest time doubles: more than a screen has pixels by far. */
const MOST = 50_000;

export class Timeline {
  /** the commands of scripts, and the waits between them */
  readonly commands = new CommandLog();
  readonly #ticks = new GrowingArray("int32");
  readonly #whos = new GrowingArray("int16");
  readonly #eventTicks = new GrowingArray("int32");
  readonly #eventCodes = new GrowingArray("int16");
  readonly #eventWhos = new GrowingArray("int16");
  #endTick = 0;
  /** as they were at the last `take`: what was cut since then leaves nothing new behind */
  #takenEndTick = -1;
  #takenStretches = 0;
  #takenEvents = 0;
  #shortest = SHORTEST;
  /** stretches and events that are as they were at the last `take` */
  #sameStretches = 0;
  #sameEvents = 0;

  /** Stretches, in the order of time; each lasts until the next begins, the last until `endTick`. */
  get stretchCount(): number {
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
      this.#whos.byteLength +
      this.#eventTicks.byteLength +
      this.#eventCodes.byteLength +
      this.#eventWhos.byteLength +
      this.commands.byteLength
    );
  }

  /** Tick at whose end stretch `index` begins: its driver moves the robot from the tick after it on. */
  tickOf(index: number): number {
    return this.#ticks.at(index);
  }

  /** Who drove in stretch `index`. */
  whoOf(index: number): Who {
    return whoOfCode(this.#whos.at(index));
  }

  /** Index of the stretch that holds the moment at the end of `tick`; -1 before the first one. */
  stretchAt(tick: number): number {
    return this.#ticks.countUpTo(tick) - 1;
  }

  /** Event `index`, in the order of time. */
  eventAt(index: number): TimelineEvent {
    const tick = this.#eventTicks.at(index);
    const code = this.#eventCodes.at(index);
    const who = whoOfCode(this.#eventWhos.at(index));
    if (code === BUMP) return { kind: "bump", tick, who };
    if (code === GOAL) return { kind: "goal", tick, who };
    if (code === EDITED_MAZE) return { kind: "edit", what: "maze", tick, who };
    if (code === EDITED_PROGRAM) return { kind: "edit", what: "program", tick, who };
    const turn = turnNames[code];
    if (turn === undefined) throw new RangeError(`The timeline has no event ${index}.`);
    return { kind: "turn", turn, tick, who };
  }

  /** How many events happened up to the end of `tick`: the index of the first one after it. */
  eventsUpTo(tick: number): number {
    return this.#eventTicks.countUpTo(tick);
  }

  /** From the end of `tick` on, `who` drives. */
  drives(tick: number, who: Exclude<Who, "mixed">): void {
    const code = codeOfWho(who);
    const last = this.#ticks.length - 1;
    if (last >= 0 && this.#whos.at(last) === code) return;
    // Nobody drove in a stretch without a tick.
    const from = last >= 0 && this.#ticks.at(last) === tick ? last : last + 1;
    this.#cutStretches(from);
    const before = this.#ticks.length - 1;
    if (before >= 0 && this.#whos.at(before) === code) return;
    this.#mergeShort(tick);
    this.#ticks.push(tick);
    this.#whos.push(code);
    if (this.#ticks.length > MOST) this.#coarsen();
  }

  /** Notes an event; one soon after another of its kind by the same driver is the same mark. */
  happened(event: TimelineEvent): void {
    const code = codeOfEvent(event);
    const who = codeOfWho(event.who);
    // Each edit has its own mark, unless there are more of them than marks: a file may bring 100,000.
    const isEditApart = event.kind === "edit" && this.#shortest === SHORTEST;
    const isSingle = event.kind === "goal" || isEditApart;
    const last = this.#eventTicks.length - 1;
    for (let at = last; at >= 0 && event.tick - this.#eventTicks.at(at) < this.#shortest; at--) {
      if (this.#eventCodes.at(at) !== code) continue;
      if (this.#eventWhos.at(at) !== who) continue;
      if (isSingle && this.#eventTicks.at(at) !== event.tick) continue;
      return;
    }
    this.#eventTicks.push(event.tick);
    this.#eventCodes.push(code);
    this.#eventWhos.push(who);
    if (this.#eventTicks.length > MOST) this.#coarsen();
  }

  /** The run has gone on to this tick. */
  reachedTick(tick: number): void {
    this.#endTick = tick;
  }

  /** Forgets what came after the end of `tick`, and what was decided there: another way follows. */
  forgetAfter(tick: number): void {
    this.#cutStretches(this.#ticks.countUpTo(tick - 1));
    let events = this.eventsUpTo(tick);
    while (this.#eventTicks.at(events - 1) === tick && isTurn(this.#eventCodes.at(events - 1))) {
      events--;
    }
    this.#cutEvents(events);
    this.commands.forgetAfter(tick);
    this.#endTick = tick;
  }

  /** What changed since the last call; null when nothing did. */
  take(): TimelineNews | null {
    const commands = this.commands.take();
    const isSame =
      commands === null &&
      this.#sameStretches === this.#ticks.length &&
      this.#sameEvents === this.#eventTicks.length &&
      this.#takenStretches === this.#ticks.length &&
      this.#takenEvents === this.#eventTicks.length &&
      this.#takenEndTick === this.#endTick;
    if (isSame) return null;
    const news: TimelineNews = {
      keptStretches: this.#sameStretches,
      ticks: this.#ticks.copyFrom(this.#sameStretches),
      whos: this.#whos.copyFrom(this.#sameStretches),
      keptEvents: this.#sameEvents,
      eventTicks: this.#eventTicks.copyFrom(this.#sameEvents),
      eventCodes: this.#eventCodes.copyFrom(this.#sameEvents),
      eventWhos: this.#eventWhos.copyFrom(this.#sameEvents),
      commands,
      endTick: this.#endTick,
    };
    this.#sameStretches = this.#ticks.length;
    this.#sameEvents = this.#eventTicks.length;
    this.#takenStretches = this.#ticks.length;
    this.#takenEvents = this.#eventTicks.length;
    this.#takenEndTick = this.#endTick;
    return news;
  }

  /** Takes in what another timeline gained or lost. */
  merge(news: TimelineNews): void {
    this.#ticks.replaceFrom(news.keptStretches, news.ticks);
    this.#whos.replaceFrom(news.keptStretches, news.whos);
    this.#eventTicks.replaceFrom(news.keptEvents, news.eventTicks);
    this.#eventCodes.replaceFrom(news.keptEvents, news.eventCodes);
    this.#eventWhos.replaceFrom(news.keptEvents, news.eventWhos);
    if (news.commands !== null) this.commands.merge(news.commands);
    this.#endTick = news.endTick;
  }

  /** The last stretch ends at `tick`: where it and the one before it were short, they are one. */
  #mergeShort(tick: number): void {
    const last = this.#ticks.length - 1;
    if (last < 1 || tick - this.#ticks.at(last) >= this.#shortest) return;
    const before = last - 1;
    const isMixed = this.#whos.at(before) === MIXED;
    if (!isMixed && this.#ticks.at(last) - this.#ticks.at(before) >= this.#shortest) return;
    this.#cutStretches(last);
    if (isMixed) return;
    this.#sameStretches = Math.min(this.#sameStretches, before);
    this.#whos.set(before, MIXED);
  }

  /** Doubles the shortest time and divides everything anew. */
  #coarsen(): void {
    this.#shortest *= 2;
    const ticks = this.#ticks.copyFrom(0);
    const whos = this.#whos.copyFrom(0);
    this.#cutStretches(0);
    for (const [index, tick] of ticks.entries()) {
      this.#mergeShort(tick);
      this.#ticks.push(tick);
      this.#whos.push(whos[index] ?? MIXED);
    }
    const events = Array.from({ length: this.eventCount }, (_, index) => this.eventAt(index));
    this.#cutEvents(0);
    for (const event of events) this.happened(event);
  }

  #cutStretches(length: number): void {
    this.#ticks.truncate(length);
    this.#whos.truncate(length);
    this.#sameStretches = Math.min(this.#sameStretches, length);
  }

  #cutEvents(length: number): void {
    this.#eventTicks.truncate(length);
    this.#eventCodes.truncate(length);
    this.#eventWhos.truncate(length);
    this.#sameEvents = Math.min(this.#sameEvents, length);
  }
}

function isTurn(code: number): boolean {
  return code < turnNames.length;
}

function codeOfWho(who: Who): number {
  switch (who) {
    case "default":
      return OTHERWISE;
    case "me":
      return ME;
    case "remote":
      return REMOTE;
    case "mixed":
      return MIXED;
    default:
      return who;
  }
}

function whoOfCode(code: number): Who {
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
