import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import type { PoolJob, PoolResult } from "./protocol/pool-messages.ts";
import { FakePoolWorker } from "./testing/fake-pool-worker.ts";
import { WorkerPool } from "./worker-pool.ts";

const program = programPresets[1]?.program;
if (program === undefined) throw new Error("a preset is gone");
const job: PoolJob = { kind: "trial", program, mazes: { kind: "tree", side: 5 }, first: 1 };

function setUp(size = 2) {
  const workers: FakePoolWorker[] = [];
  const pool = new WorkerPool(() => {
    const worker = new FakePoolWorker();
    workers.push(worker);
    return worker;
  }, size);
  const results: [unit: number, result: PoolResult][] = [];
  const ends: string[] = [];
  const run = (count: number) =>
    pool.run(job, count, {
      onResult: (result, unit) => results.push([unit, result]),
      onEnd: (reason) => ends.push(reason),
    });
  const answerAll = () => {
    while (workers.filter((worker) => worker.answer()).length > 0);
  };
  return { workers, pool, results, ends, run, answerAll };
}

describe("workers that share a job", () => {
  it("run each unit once", () => {
    const { results, ends, run, answerAll } = setUp(3);
    run(50);
    answerAll();
    const units = results.map(([unit]) => unit).toSorted((a, b) => a - b);
    expect(units).toEqual(Array.from({ length: 50 }, (_, unit) => unit));
    expect(ends).toEqual([]);
  });

  it("are as many as there are units to run at the same time", () => {
    const { workers, run, results, answerAll } = setUp(4);
    run(1);
    expect(workers.map(({ waiting }) => waiting)).toEqual([1]);
    answerAll();
    expect(results).toHaveLength(1);
  });

  it("drop their units on a stop, and the result of a running unit is ignored", () => {
    const { workers, pool, results, ends, run, answerAll } = setUp();
    run(50);
    workers[0]?.answer();
    pool.stop();
    expect(workers.map(({ waiting }) => waiting)).toEqual([0, 0]);
    answerAll();
    expect(results).toHaveLength(1);
    expect(ends).toEqual(["stopped"]);
    pool.stop();
    expect(ends).toEqual(["stopped"]);
  });

  it("start another job in place of the current one", () => {
    const { workers, results, ends, run, answerAll } = setUp();
    run(50);
    workers[0]?.answer();
    run(3);
    answerAll();
    expect(ends).toEqual(["stopped"]);
    expect(results).toHaveLength(4);
  });

  it("end with a worker that fails, and new ones run the next job", () => {
    const { workers, results, ends, run, answerAll } = setUp();
    run(50);
    workers[1]?.onerror?.({ message: "" } as ErrorEvent);
    expect(ends).toEqual(["failed"]);
    expect(workers.map(({ isOver }) => isOver)).toEqual([true, true]);
    run(2);
    expect(workers).toHaveLength(4);
    answerAll();
    expect(results).toHaveLength(2);
  });
});
