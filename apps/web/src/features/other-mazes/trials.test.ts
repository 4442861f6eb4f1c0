import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { mazeOf } from "../../simulator/pool-worker/maze-trial.ts";
import { FakePoolWorker } from "../../simulator/testing/fake-pool-worker.ts";
import { recordRun } from "../../simulator/record-runs.ts";
import { WorkerPool } from "../../simulator/worker-pool.ts";
import { countOutcomes, Trials, type TrialChoice } from "./trials.ts";

const program = programPresets[1]?.program;
if (program === undefined) throw new Error("a preset is gone");
const rightWall = program;
const choice: TrialChoice = { kind: "tree", side: 5, first: 1 };

function setUp(size = 3) {
  const workers: FakePoolWorker[] = [];
  const waits: (() => void)[] = [];
  const pool = new WorkerPool(() => {
    const worker = new FakePoolWorker();
    workers.push(worker);
    return worker;
  }, size);
  const trials = new Trials(pool, (show) => waits.push(show));
  const later = () => {
    for (const show of waits.splice(0)) show();
  };
  const answerAll = () => {
    while (workers.filter((worker) => worker.answer()).length > 0);
    later();
  };
  return { workers, trials, later, answerAll, state: () => trials.store.getState() };
}

describe("trying a program in other mazes", () => {
  it("tries each of the hundred seeds once, on all workers", () => {
    const { workers, trials, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    expect(workers.every(({ waiting }) => waiting > 0)).toBe(true);
    answerAll();
    expect(state().state).toBe("done");
    expect([...state().results.keys()].toSorted((a, b) => a - b)).toEqual(
      Array.from({ length: 100 }, (_, at) => at + 1),
    );
    expect(countOutcomes(state().results)).toEqual({ works: 100, bump: 0, "time-limit": 0 });
  });

  it("leaves no worker with many mazes while another has none", () => {
    const { workers, trials } = setUp();
    trials.start(choice, rightWall);
    let worst = 0;
    while (workers.filter((worker) => worker.answer()).length > 0) {
      const waiting = workers.map((worker) => worker.waiting);
      if (Math.min(...waiting) === 0) worst = Math.max(worst, ...waiting);
    }
    expect(worst).toBeLessThanOrEqual(2);
  });

  it("lets no worker wait for the page at the start", () => {
    const { workers, trials } = setUp(2);
    trials.start(choice, rightWall);
    expect(workers.map(({ waiting }) => waiting)).toEqual([25, 19]);
  });

  it("draws pictures each second time while mazes are tried, and all at the end", () => {
    const { workers, trials, later, answerAll, state } = setUp(1);
    trials.start(choice, rightWall);
    const pictures: number[] = [];
    for (let shown = 1; shown <= 4; shown++) {
      workers[0]?.answer();
      later();
      pictures.push(state().pictured.size);
    }
    expect(pictures).toEqual([0, 2, 2, 4]);
    answerAll();
    expect(state().pictured.size).toBe(100);
  });

  it("draws the pictures of what was tried when it is stopped", () => {
    const { workers, trials, state } = setUp(1);
    trials.start(choice, rightWall);
    workers[0]?.answer();
    workers[0]?.answer();
    trials.stop();
    expect(state().pictured.size).toBe(2);
  });

  it("shows results together from time to time, and the last at once", () => {
    const { workers, trials, later, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    workers[0]?.answer();
    workers[1]?.answer();
    expect(state().results.size).toBe(0);
    later();
    expect(state().results.size).toBe(2);
    workers[0]?.answer();
    expect(state().results.size).toBe(2);
    while (workers.filter((worker) => worker.answer()).length > 0);
    expect(state().state).toBe("done");
    answerAll();
    expect(state().results.size).toBe(100);
  });

  it("shows a result at once if none was shown for a while", () => {
    const { workers, trials, later, state } = setUp();
    trials.start(choice, rightWall);
    later();
    workers[0]?.answer();
    expect(state().results.size).toBe(1);
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

  it("reports a failure when a worker breaks, and starts new workers on the next try", () => {
    const { workers, trials, answerAll, state } = setUp();
    trials.start(choice, rightWall);
    workers[1]?.onerror?.({ message: "" } as ErrorEvent);
    expect(state().state).toBe("failed");
    expect(workers.every(({ isOver }) => isOver)).toBe(true);
    trials.start(choice, rightWall);
    answerAll();
    expect(state().state).toBe("done");
  });

  it("records a run, and returns none if it is closed meanwhile", async () => {
    const { workers, trials } = setUp(1);
    const maze = mazeOf(choice, 1, "Tree");
    const run = { maze, attempt: rightWall, ticks: 60 };
    const recorded = recordRun(trials.pool, run);
    workers[0]?.answer();
    expect((await recorded)?.ok).toBe(true);
    const late = recordRun(trials.pool, run);
    trials.close();
    expect(await late).toBeNull();
  });
});
