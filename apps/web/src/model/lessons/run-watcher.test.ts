import { mazeOf } from "@corridor/challenge";
import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import { expect, it } from "vitest";
import { FakePoolWorker } from "../../simulator/testing/fake-pool-worker.ts";
import { WorkerPool } from "../../simulator/worker-pool.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { RunWatcher } from "./run-watcher.ts";
import { lessonsPage } from "./testing/lessons-page.ts";

const task = taskIn([firstMaze], {
  unseen: { kind: "tree", columns: 7, rows: 7, seed: 7, count: 5, pass: 4 },
});
const FIRST_UNSEEN = task.mazes.length;
const way = { tone: "info", stays: true, action: { label: "missions:lesson.back" } };

/** The task is open, with the program that a check has run. */
function setUp() {
  const page = lessonsPage();
  page.challenge.setState({ lesson: lessonOfTasks("One task", [task]), index: 0 });
  const worker = new FakePoolWorker();
  const pool = new WorkerPool(() => worker, 1);
  const watcher = new RunWatcher(page.ports, pool, { showMaze: () => undefined });
  /** Records the run of an unseen maze, and opens it. */
  const load = async (maze: number) => {
    while (worker.answer());
    await expect.poll(() => page.sent.at(-1)).toMatchObject({ type: "load-run" });
    const asked = page.sent.at(-1);
    if (asked?.type !== "load-run") throw new Error("no run to load");
    const loaded = { ok: true, maze: mazeOf(task, maze), program: firstProgram } as const;
    page.report({ type: "run-loaded", id: asked.id, loaded });
  };
  return { ...page, watcher, load };
}

it("opens an unseen maze in which the program passes at its start, with a way back that stays", async () => {
  const { watcher, load, sent, messages, workspace } = setUp();
  const before = workspace.getState().maze;
  const opened = watcher.open({ maze: FIRST_UNSEEN, ticks: 60 }, "Tree 1", "It passes.");
  await load(FIRST_UNSEEN);
  await opened;
  expect(workspace.getState().maze).toEqual(mazeOf(task, FIRST_UNSEEN));
  expect(sent.slice(-1)).toEqual([{ type: "seek", tick: 0 }]);
  expect(messages()).toMatchObject([{ ...way, text: "It passes." }]);
  messages()[0]?.action?.run();
  expect(workspace.getState().maze).toEqual(before);
});

it("plays the last seconds of a failed run in an unseen maze, with a way back that stays", async () => {
  const { watcher, load, sent, messages } = setUp();
  const nothing = {
    maze: null,
    line: null,
    place: null,
    needed: null,
    found: null,
    decision: null,
  };
  const failure = { ...nothing, code: "bump", tick: 300 } as const;
  const opened = watcher.watch({ maze: FIRST_UNSEEN, failure }, "Tree 1", "It bumps.");
  await load(FIRST_UNSEEN);
  await opened;
  expect(sent.slice(-2)).toEqual([{ type: "seek", tick: 180 }, { type: "play" }]);
  expect(messages()).toMatchObject([{ ...way, text: "It bumps." }]);
});
