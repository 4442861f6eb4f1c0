/**
 * What the coach has to say of a program that drives: how a bump could have been kept off, and that the
 * robot gets nowhere. Everything is said once; another program or another maze begins anew.
 */
import { LoopWatch, mendsForBump, storyOfBump, type LoopNotice, type Mend } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import { Simulation } from "@corridor/simulation";

/** Mends that a card has room for. */
const MOST_MENDS = 2;
/** A long way to a wall is tried from so many ticks before it. */
const MOST_TICKS = 600;

export class RunCoach {
  readonly #explained = new Set<LineRef>();
  #watch: LoopWatch | null = null;
  #maze: MazeDocument | null = null;
  #program: ProgramDocument | null = null;

  /** A new run: what was said of the one before may be said again. */
  begin(): void {
    this.#explained.clear();
    this.#watch = null;
  }

  /** Looks at a tick that `line` drove. @returns what there is to say of it; mostly nothing */
  look(run: Run, line: LineRef): LoopNotice | null {
    this.#follow(run);
    this.#watch ??= new LoopWatch(run.maze);
    return this.#watch.look(run.cell, run.isStopped, run.isManoeuvring, line);
  }

  /**
   * The newest tick ended in a bump of `line`.
   * @returns edits that would have kept it off; null where a bump of this line was explained before
   */
  explain(recording: Recording, line: LineRef): readonly Mend[] | null {
    const { run } = recording;
    this.#follow(run);
    if (this.#explained.has(line)) return null;
    this.#explained.add(line);
    const { cause, maze, program, tick } = run;
    if (cause === null) return [];
    const playback = recording.playback();
    const from = Math.max(cause.decidedAt, tick - MOST_TICKS);
    playback.goTo(from);
    const state = playback.run.save().simulation;
    const atDecision = (): Simulation => {
      const simulation = new Simulation(maze);
      simulation.restore(state);
      return simulation;
    };
    const readings = run.report().sensors;
    const story = storyOfBump(cause);
    return mendsForBump(
      { program, line, story, readings, atDecision, ticks: tick - from },
      MOST_MENDS,
    );
  }

  #follow({ maze, program }: Run): void {
    if (maze === this.#maze && program === this.#program) return;
    this.#maze = maze;
    this.#program = program;
    this.begin();
  }
}
