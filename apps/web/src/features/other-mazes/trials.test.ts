import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { mazeOf, minutesFor, recordTrial, tryMaze } from "../../worker/maze-trial.ts";
import type { ToTrialWorker } from "../../worker/trial-messages.ts";
import { TrialPool, type TrialPort } from "./trial-pool.ts";
import { countOutcomes, Trials, type TrialChoice } from "./trials.ts";

const program = programPresets[1]?.program;
if (program === undefined) throw new Error("a preset is gone");
const rightWall = program;
const choice: TrialChoice = { kind: "tree", side: 5, first: 1 };

/** A worker that answers when it is told to. */
class FakeWorker implements TrialPort {
  onmessage: TrialPort["onmessage"] = null;
  onerror: TrialPort["onerror"] = null;
  isOver = false;
  readonly waiting: ToTrialWorker[] = [];

  postMessage(message: ToTrialWorker): void {
    this.waiting.push(message);
  }

  terminate(): void {
    this.isOver = true;
  }

  /** Answers the oldest message. @returns whether there was one */
  answer(): boolean {
    const message = this.waiting.shift();
    if (message === undefined) return false;
    const data =
      message.type === "record"
        ? ({
            type: "recorded",
            written: recordTrial(message.maze, message.program, message.ticks),
          } as const)
        : ({
            type: "result",
            job: message.job,
            result: resultOf(message),
          } as const);
    this.onmessage?.({ data } as MessageEvent);
    return true;
  }
}

function resultOf({ mazes, seed, program: tried }: Extract<ToTrialWorker, { type: "try" }>) {
  const maze = mazeOf(mazes, seed);
  return { seed, maze, ...tryMaze(maze, tried, minutesFor(mazes.side)) };
}

function setUp(size = 3) {
  const workers: FakeWorker[] = [];
  const frames: (() => void)[] = [];
  const pool = new TrialPool(() => {
    const worker = new FakeWorker();
    workers.push(worker);
    return worker;
  }, size);
  const trials = new Trials(pool, (show) => frames.push(show));
  const frame = () => {
    for (const show of frames.splice(0)) show();
  };
  const answerAll = () => {
    while (workers.some((worker) => worker.answer()));
    frame();
  };
  return { workers, trials, frame, answerAll, state: () => trials.store.getState() };
}

describe("trying a program in other mazes", () => {
  it("tries each of the hundred seeds once, on all workers", () => {
    const { workers, trials, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    expect(workers.map(({ waiting }) => waiting.length)).toEqual([2, 2, 2]);
    answerAll();
    expect(state().state).toBe("done");
    expect([...state().results.keys()].toSorted((a, b) => a - b)).toEqual(
      Array.from({ length: 100 }, (_, at) => at + 1),
    );
    expect(countOutcomes(state().results)).toEqual({ works: 100, bump: 0, "time-limit": 0 });
  });

  it("shows results once a frame", () => {
    const { workers, trials, frame, state } = setUp();
    trials.start(choice, rightWall);
    workers[0]?.answer();
    workers[1]?.answer();
    expect(state().results.size).toBe(0);
    frame();
    expect(state().results.size).toBe(2);
  });

  it("stops, and shows what it has", () => {
    const { workers, trials, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    workers[0]?.answer();
    trials.stop();
    expect(state().state).toBe("stopped");
    answerAll();
    expect(state().results.size).toBe(1);
  });

  it("drops the results of a choice that was changed meanwhile", () => {
    const { workers, trials, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    workers[0]?.answer();
    trials.start({ ...choice, first: 101 }, rightWall);
    answerAll();
    expect(state().state).toBe("done");
    expect(Math.min(...state().results.keys())).toBe(101);
  });

  it("says that it failed when a worker breaks, and starts new ones when asked again", () => {
    const { workers, trials, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    workers[1]?.onerror?.({ message: "" } as ErrorEvent);
    expect(state().state).toBe("failed");
    expect(workers.every(({ isOver }) => isOver)).toBe(true);
    trials.start(choice, rightWall);
    answerAll();
    expect(state().state).toBe("done");
  });

  it("records a run, and gives none when it is closed meanwhile", async () => {
    const { workers, trials } = setUp(1);
    const maze = mazeOf(choice, 1, "Tree");
    const recorded = trials.pool.record(maze, rightWall, 60);
    workers[0]?.answer();
    expect((await recorded)?.ok).toBe(true);
    const late = trials.pool.record(maze, rightWall, 60);
    trials.close();
    expect(await late).toBeNull();
  });
});
