/**
 * A run with its past: the live run, and the data to display any earlier tick, to continue from
 * there with other inputs, and to create a document of the run.
 *
 * A recording stores the inputs, sparse keyframes, the timeline and the trail in packed arrays. The
 * class of the live run recomputes all other ticks from the previous keyframe.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Command } from "@corridor/protocol";
import { Inputs, shareUnchanged, type Documents } from "./inputs.ts";
import { Keyframes } from "./keyframes.ts";
import { PositionLog } from "./position-log.ts";
import { Playback } from "./playback.ts";
import type { RunDocument } from "./run-document.ts";
import type { RunInput, TimedInput } from "./run-input.ts";
import { MAX_RUN_INPUTS, MAX_RUN_TEXT_LENGTH, MAX_RUN_TICKS } from "./run-limits.ts";
import { Run, type RunState } from "./run.ts";
import { Timeline, type TurnName } from "./timeline.ts";
import { TrailPen } from "./trail-pen.ts";

/** A run as a document and as the text of its file, or the reason why it cannot be written. */
export type WrittenRun =
  | { ok: true; run: RunDocument; text: string }
  | { ok: false; reason: "too-long" | "too-many-inputs" };

/** The part of a run that is already stored. */
export interface RunCheckpoint {
  /** changes when stored inputs become invalid */
  generation: number;
  /** number of stored inputs */
  inputs: number;
}

/** Data to add to a stored run so that it can be replayed up to its newest tick. */
export interface RunUpdate {
  /** the documents at the start of the run; null if the inputs extend the stored ones */
  first: { maze: MazeDocument; program: ProgramDocument } | null;
  inputs: TimedInput[];
  ticks: number;
  digest: string;
  /** the checkpoint after storing this update */
  checkpoint: RunCheckpoint;
}

/** Edits of one tick: the index of the first edit, and the state before it. */
interface EditsOfTick {
  from: number;
  before: RunState;
}

export class Recording {
  readonly timeline = new Timeline();
  /** corners of the trail */
  readonly corners = new PositionLog();
  /** position of the robot's centre at each bump */
  readonly bumps = new PositionLog();
  readonly #run: Run;
  readonly #inputs = new Inputs();
  readonly #pen: TrailPen;
  #first: Documents;
  #keyframes: Keyframes;
  #edits: EditsOfTick | null = null;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    this.#first = { maze, program };
    this.#run = new Run(maze, program);
    const { x, y } = this.#run;
    this.#pen = new TrailPen(x, y);
    this.corners.push(0, x, y);
    this.#keyframes = new Keyframes({ state: this.#run.save(), pen: this.#pen.save() });
  }

  /** The live run at its newest tick. Only `addInput` and `step` may change it. */
  get run(): Run {
    return this.#run;
  }

  /** Increases when inputs are added or deleted. An earlier document is then out of date. */
  get revision(): number {
    return this.#inputs.revision;
  }

  /**
   * Returns the data that a store needs to replay the run up to now.
   * @param stored the part that is already stored, or null
   * @returns null if the run exceeds the bounds of a document
   */
  updateSince(stored: RunCheckpoint | null): RunUpdate | null {
    const { tick } = this.#run;
    const { generation, length } = this.#inputs;
    if (tick > MAX_RUN_TICKS || length > MAX_RUN_INPUTS) return null;
    const follows = stored?.generation === generation;
    return {
      first: follows ? null : this.#first,
      inputs: this.#inputs.list(follows ? stored.inputs : 0),
      ticks: tick,
      digest: this.#run.digest(),
      checkpoint: { generation, inputs: length },
    };
  }

  /** Tick of the newest input up to the end of a tick; 0 without any input. */
  newestInputUpTo(tick: number): number {
    return this.#inputs.at(this.#inputs.indexAt(tick + 1) - 1)?.tick ?? 0;
  }

  /** Approximate memory use in bytes. */
  get byteLength(): number {
    const { timeline, corners, bumps } = this;
    return (
      timeline.byteLength +
      corners.byteLength +
      bumps.byteLength +
      this.#keyframes.byteLength +
      this.#inputs.byteLength(this.#first)
    );
  }

  /**
   * Adds an input at the end of the newest tick. After an edit, the documents of the run are equal
   * to the given ones, but not the same objects.
   * @returns false, without any change, if the input is not possible
   */
  addInput(given: RunInput): boolean {
    const run = this.#run;
    const input = shareUnchanged(given, run);
    if (input.do === "program" && run.tick === 0 && this.#inputs.length === 0) {
      this.#replaceStartProgram(input.program);
      return true;
    }
    const isEdit = input.do === "program" || input.do === "maze";
    const edits = isEdit ? this.#editsOfThisTick() : null;
    if (!run.apply(input)) return false;
    if (isEdit && edits !== null) this.#reapplyEdits(edits, input);
    this.#edits = edits;
    this.#inputs.add(run.tick, input);
    this.#recordCommand(input);
    if (isEdit) {
      this.timeline.recordEvent({
        kind: "edit",
        what: input.do,
        tick: run.tick,
        driver: run.timelineDriver,
      });
    }
    return true;
  }

  /** Returns the trailing edits of this tick, and the state before them. */
  #editsOfThisTick(): EditsOfTick {
    const edits = this.#edits;
    if (edits !== null && edits.before.simulation.tick === this.#run.tick) return edits;
    return { from: this.#inputs.length, before: this.#run.save() };
  }

  /** Retains only the last edit of each kind in one tick, as if the others never existed. */
  #reapplyEdits(
    { from, before }: EditsOfTick,
    last: Extract<RunInput, { do: "program" | "maze" }>,
  ): void {
    if (from === this.#inputs.length) return;
    this.#run.restore(before);
    for (const input of this.#inputs.dropEdits(from, last.do)) this.#run.apply(input);
    this.#run.apply(last);
  }

  /** Replaces the starting program if it is edited before the first tick and input. */
  #replaceStartProgram(program: ProgramDocument): void {
    this.#first = { ...this.#first, program };
    this.#run.restore(new Run(this.#first.maze, program).save());
    this.#keyframes = new Keyframes({ state: this.#run.save(), pen: this.#pen.save() });
    this.#inputs.invalidate();
  }

  /** Runs one tick. */
  step(): void {
    const { timeline } = this;
    const run = this.#run;
    const { timelineDriver: driver, bumps, goalTick } = run;
    const from = run.tick;
    timeline.commands.setWaiting(from, run.driver === "remote" && run.command === null);
    if (run.decidedAt === from) {
      timeline.recordDriver(from, driver);
      const turn = turnOf(run.decision);
      if (turn !== null) timeline.recordEvent({ kind: "turn", turn, tick: from, driver });
    }
    run.step();
    const { tick } = run;
    timeline.advanceTo(tick);
    if (run.command === null) timeline.commands.recordEnd(tick, run.commandEnding ?? "completed");
    const pen = this.#pen;
    if (pen.moveTo(run.x, run.y)) this.corners.push(tick, pen.cornerX, pen.cornerY);
    if (run.bumps !== bumps) {
      this.bumps.push(tick, run.x, run.y);
      timeline.recordEvent({ kind: "bump", tick, driver });
    }
    if (run.goalTick !== goalTick) timeline.recordEvent({ kind: "goal", tick, driver });
    if (tick >= this.#keyframes.dueAt) {
      this.#keyframes.add({ state: run.save(), pen: this.#pen.save() });
    }
  }

  /** Records the start and the end of script commands caused by an accepted input. */
  #recordCommand(input: RunInput): void {
    const { commands } = this.timeline;
    const { tick, command: running, commandEnding } = this.#run;
    switch (input.do) {
      case "command":
        commands.recordEnd(tick, "completed");
        if (input.seq === undefined) return;
        commands.recordStart(input.seq, input.command, tick);
        if (running === null) commands.recordEnd(tick, commandEnding ?? "completed");
        return;
      case "cancel":
        return commands.recordEnd(tick, input.superseded === true ? "superseded" : "cancelled");
      case "driver":
        return commands.recordEnd(tick, "cancelled");
      case "program":
      case "maze":
        return;
    }
  }

  /** Creates a playback of the recorded data. */
  playback(): Playback {
    return new Playback(this.#inputs, this.#keyframes);
  }

  /**
   * Deletes everything after the end of `tick`, and restores the live run there with its inputs.
   */
  truncate(tick: number): void {
    const run = this.#run;
    const { state, pen } = this.#keyframes.before(tick);
    this.#edits = null;
    this.#inputs.truncateAfter(tick);
    this.#keyframes.truncateAfter(tick);
    this.timeline.truncateAfter(tick);
    this.corners.truncateAfter(tick);
    this.bumps.truncateAfter(tick);
    this.#pen.restore(pen);
    run.restore(state);
    let next = this.#inputs.indexAt(run.tick);
    for (;;) {
      for (
        let input = this.#inputs.at(next);
        input?.tick === run.tick;
        input = this.#inputs.at(++next)
      ) {
        run.apply(input);
      }
      if (run.tick >= tick) return;
      run.step();
      this.#pen.moveTo(run.x, run.y);
    }
  }

  /** Tick of the decision before the current decision at `tick`; 0 if there is none. */
  decisionBefore(tick: number, playback: Playback): number {
    if (tick <= 0) return 0;
    playback.seek(tick - 1);
    return playback.run.decidedAt;
  }

  /** Tick of the first decision after `tick`, or null. */
  decisionAfter(tick: number, playback: Playback): number | null {
    const { run } = playback;
    const skipped = this.#keyframes.decidedBefore(tick).state.simulation.tick;
    playback.seek(Math.max(tick, skipped));
    while (run.decidedAt <= tick && run.tick < this.#run.tick) playback.step();
    return run.decidedAt > tick ? run.decidedAt : null;
  }

  /** Writes the run so far as a document. */
  toDocument(name: string): WrittenRun {
    const { tick } = this.#run;
    if (tick > MAX_RUN_TICKS) return { ok: false, reason: "too-long" };
    if (this.#inputs.length > MAX_RUN_INPUTS) return { ok: false, reason: "too-many-inputs" };
    const head = {
      format: "corridor/run",
      version: 1,
      name,
      ...this.#first,
      seed: 0,
      ticks: tick,
    } as const;
    const inputs = this.#inputs.list();
    const digest = this.#run.digest();
    const text = textOf(head, inputs, digest);
    if (text === null) return { ok: false, reason: "too-long" };
    return { ok: true, run: { ...head, inputs, digest }, text };
  }
}

/** Writes the JSON of a run without whitespace; null if it exceeds the maximum text length. */
function textOf(head: object, inputs: readonly TimedInput[], digest: string): string | null {
  const prefix = `${JSON.stringify(head).slice(0, -1)},"inputs":[`;
  const suffix = `],"digest":"${digest}"}`;
  let length = prefix.length + suffix.length;
  const texts: string[] = [];
  // Input by input, because thousands of large mazes exceed the maximum length of a string.
  for (const input of inputs) {
    const text = JSON.stringify(input);
    length += text.length + 1;
    if (length > MAX_RUN_TEXT_LENGTH) return null;
    texts.push(text);
  }
  return prefix + texts.join(",") + suffix;
}

/** Returns the turn of a command, or null. */
function turnOf(command: Command): TurnName | null {
  switch (command.action) {
    case "left 90":
    case "right 90":
    case "turn 180":
    case "delayed left 90":
    case "delayed right 90":
      return command.action;
    case "turn":
      if (command.degrees === 0) return null;
      return command.degrees < 0 ? "turn left" : "turn right";
    case "forward":
    case "reverse":
    case "stop":
    case "move":
    case "drive":
      return null;
  }
}
