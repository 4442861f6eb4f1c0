import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { FakePoolWorker } from "../../simulator/testing/fake-pool-worker.ts";
import { WorkerPool } from "../../simulator/worker-pool.ts";
import { Trials } from "./trials.ts";
import { tryWhileOpen } from "./try-while-open.ts";

const MINUTE_MS = 60_000;

function setUp() {
  const [maze] = mazePresets;
  const [program] = programPresets;
  if (maze === undefined || program === undefined) throw new Error("a preset is gone");
  const workspace = createWorkspaceStore(maze.maze, program.program);
  const screen = createScreenStore();
  const workers: FakePoolWorker[] = [];
  const pool = new WorkerPool(() => {
    const worker = new FakePoolWorker();
    workers.push(worker);
    return worker;
  }, 1);
  const trials = new Trials(pool, (show) => show());
  const mount = () => tryWhileOpen({ screen, workspace }, trials);
  const press = (isTryingMazes: boolean) => screen.setState({ isTryingMazes });
  return { workers, trials, mount, press };
}

describe("the workers that try other mazes", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it("start on the press, and stay for a minute after the dialog is closed", () => {
    const { workers, trials, mount, press } = setUp();
    mount();
    expect(workers).toHaveLength(0);
    press(true);
    expect(trials.store.getState().state).toBe("running");
    press(false);
    vi.advanceTimersByTime(MINUTE_MS - 1);
    expect(workers.map(({ isOver }) => isOver)).toEqual([false]);
    vi.advanceTimersByTime(1);
    expect(workers.map(({ isOver }) => isOver)).toEqual([true]);
  });

  it("stay if the button is pressed again within the minute", () => {
    const { workers, mount, press } = setUp();
    mount();
    press(true);
    press(false);
    vi.advanceTimersByTime(MINUTE_MS / 2);
    press(true);
    vi.advanceTimersByTime(2 * MINUTE_MS);
    expect(workers.map(({ isOver }) => isOver)).toEqual([false]);
  });

  it("of the next page are not stopped by the timer of the previous page", () => {
    const { workers, mount, press } = setUp();
    const leave = mount();
    press(true);
    press(false);
    leave();
    mount();
    press(true);
    vi.advanceTimersByTime(2 * MINUTE_MS);
    expect(workers.map(({ isOver }) => isOver)).toEqual([true, false]);
  });
});
