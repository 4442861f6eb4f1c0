/**
 * What the coach has to say of a program that drives: how a bump could have been kept off, and that the
 * robot gets nowhere. Everything is said once; another program or another maze begins anew.
 */
import {
  LoopWatch,
  mendOfEarlierTurn,
  mendsForBump,
  storyOfBump,
  type BumpScene,
  type LoopNotice,
  type Mend,
} from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import type { Playback, Recording, Run } from "@corridor/recording";
import { Simulation } from "@corridor/simulation";

/** Mends that a card has room for. */
const MOST_MENDS = 2;
/** A long way to a wall is tried from so many ticks before it. */
const MOST_TICKS = 600;
/** A robot that turned too early may turn again at once, as its side is still open. */
const MOST_TURNS = 3;

/** What a card at a bump tells of. */
export interface Explained {
  /** the one that took the decision; it may have been edited while its turn went on */
  program: ProgramDocument;
  /** edits of it that would have kept the bump off, each tried */
  mends: readonly Mend[];
}

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
    const isWaiting = run.decision.action === "stop";
    return this.#watch.look(run.cell, run.isStopped, run.isManoeuvring, line, isWaiting);
  }

  /**
   * The newest tick ended in a bump of `line`.
   * @returns null where a bump of this line was explained before
   */
  explain(recording: Recording, line: LineRef): Explained | null {
    const { run } = recording;
    this.#follow(run);
    if (this.#explained.has(line)) return null;
    this.#explained.add(line);
    const { cause, maze, tick } = run;
    const hasReachedGoal = run.goalTick !== null;
    if (cause === null) return { program: run.program, mends: [] };
    const playback = recording.playback();
    playback.goTo(cause.decidedAt);
    const { program } = playback.run;
    const sceneFrom = (from: number) => {
      playback.goTo(from);
      const state = playback.run.save().simulation;
      const atDecision = (): Simulation => {
        const simulation = new Simulation(maze);
        simulation.restore(state);
        return simulation;
      };
      return { program, atDecision, ticks: tick - from, hasReachedGoal };
    };
    const readings = run.report().sensors;
    const story = storyOfBump(cause);
    const from = Math.max(cause.decidedAt, tick - MOST_TICKS);
    const mends = mendsForBump({ ...sceneFrom(from), line, story, readings }, MOST_MENDS);
    const earlier =
      story.kind === "steady" ? this.#earlierTurn(recording, sceneFrom, playback) : null;
    return {
      program,
      mends: earlier === null ? mends : [earlier, ...mends].slice(0, MOST_MENDS),
    };
  }

  /** The turn before the bump as a delayed one, where that keeps it off; or the turn before that one. */
  #earlierTurn(
    recording: Recording,
    sceneFrom: (tick: number) => Omit<BumpScene, "line" | "story" | "readings">,
    playback: Playback,
  ): Mend | null {
    const { cause, tick } = recording.run;
    let at = cause?.decidedAt ?? 0;
    for (let back = 0; back < MOST_TURNS && at > 0; back++) {
      at = recording.decisionBefore(at, playback);
      if (tick - at > MOST_TICKS) return null;
      const scene = sceneFrom(at);
      const { line, isManoeuvring, program } = playback.run;
      // Another program's line is none of the one that bumped.
      if (line === null || !isManoeuvring || program !== scene.program) return null;
      const mend = mendOfEarlierTurn({ ...scene, line });
      if (mend !== null) return mend;
    }
    return null;
  }

  #follow({ maze, program }: Run): void {
    if (maze === this.#maze && program === this.#program) return;
    this.#maze = maze;
    this.#program = program;
    this.begin();
  }
}
