import { lessonMark } from "@corridor/challenge";
import { decodeLink, encodeLink } from "@corridor/link";
import { describe, expect, it } from "vitest";
import { FakePoolWorker } from "../../simulator/testing/fake-pool-worker.ts";
import { WorkerPool } from "../../simulator/worker-pool.ts";
import { HandInCheck, type HandInRow } from "./check-hand-ins.ts";
import { entriesOf, type ChosenTask } from "./hand-in-entries.ts";
import { handInsCsv } from "./hand-ins-csv.ts";
import { linkOf, programOf, sampleLesson } from "./testing/sample-lesson.ts";

const tasks = sampleLesson.tasks.map((task, at): ChosenTask => ({ task, number: at + 1 }));
const [first] = tasks;
if (first === undefined) throw new Error("no task");

function setUp() {
  const workers: FakePoolWorker[] = [];
  const pool = new WorkerPool(() => {
    const worker = new FakePoolWorker();
    workers.push(worker);
    return worker;
  }, 2);
  const check = new HandInCheck(
    pool,
    (show) => show(),
    (_, maze) => `Maze ${maze + 1}`,
  );
  const answerAll = () => {
    while (workers.filter((worker) => worker.answer()).length > 0);
  };
  const start = (lines: readonly string[], chosen: readonly ChosenTask[] = [first as ChosenTask]) =>
    check.start(chosen, entriesOf([], lines.join("\n"), sampleLesson));
  return { workers, check, start, answerAll, state: () => check.store.getState() };
}

const rightWall = linkOf(programOf("right-wall", "Juniper"));
const leftWall = linkOf(programOf("left-wall", "Comet"));
const backAndForth = linkOf(programOf("back-and-forth", ""));

function verdictOf({ checked }: HandInRow): string {
  return checked.ok ? checked.result.verdict : checked.code;
}

describe("a check of hand-ins", () => {
  it("counts the mazes in which each passes, and finds its first failure", () => {
    const { start, answerAll, state } = setUp();
    start([rightWall, leftWall, backAndForth]);
    expect(state()).toMatchObject({ state: "running", done: 0, count: 21 });
    answerAll();
    expect(state()).toMatchObject({ state: "done", done: 21 });
    expect(state().rows).toMatchObject([
      {
        number: 1,
        title: "Juniper",
        checked: { result: { verdict: "all", passed: 7, mazes: 7, lines: 2, first: null } },
      },
      {
        number: 2,
        checked: { result: { verdict: "fails", ticks: null, first: { maze: 1 } } },
      },
      {
        number: 3,
        checked: { result: { verdict: "time-limit", passed: 0, first: { maze: 0 } } },
      },
    ]);
  });

  it("names another hand-in with the identical program, whatever the program's name", () => {
    const { start, answerAll, state } = setUp();
    start([rightWall, leftWall, linkOf(programOf("right-wall", "Pixel"))]);
    // Identical programs run once.
    expect(state().count).toBe(14);
    answerAll();
    expect(state().rows.map(({ sameAs }) => sameAs)).toEqual([3, null, 1]);
    expect(state().rows.map(verdictOf)).toEqual(["all", "fails", "all"]);
  });

  it("checks the others if a hand-in cannot be read or is not allowed", () => {
    const { start, answerAll, state } = setUp();
    const { rules, ...plain } = programOf("right-wall", "Long");
    start(["Anna", linkOf({ ...plain, rules: [...rules, ...rules] }), rightWall]);
    expect(state().count).toBe(7);
    answerAll();
    expect(state().rows.map(verdictOf)).toEqual(["unknown-version", "not-allowed", "all"]);
  });

  it("checks a completion code in its own task only", () => {
    const { start, answerAll, state } = setUp();
    const code = encodeLink({
      completion: {
        lesson: lessonMark(sampleLesson),
        task: 1,
        attempt: programOf("right-wall", ""),
      },
    });
    if (!code.ok) throw new Error(code.code);
    start([code.text, rightWall], tasks);
    answerAll();
    const places = state().rows.map(({ number, checked }) =>
      checked.ok ? [number, checked.task.number] : [number, checked.code],
    );
    expect(places).toEqual([
      [1, 2],
      [2, 1],
      [2, 2],
    ]);
    start([code.text]);
    expect(state().rows.map(verdictOf)).toEqual(["other-task"]);
  });

  it("stops at once, and keeps what it has", () => {
    const { workers, check, start, state } = setUp();
    start([leftWall, backAndForth]);
    workers[0]?.answer();
    workers[0]?.answer();
    check.stop();
    expect(state()).toMatchObject({ state: "stopped", done: 2, count: 14 });
    expect(state().rows.map(verdictOf)).toEqual(["open", "open"]);
    expect(handInsCsv(state().rows).split("\r\n")).toHaveLength(2);
  });

  it("offers the last seconds of each failed run to watch", async () => {
    const { start, answerAll, state } = setUp();
    start([rightWall, leftWall]);
    answerAll();
    await Promise.resolve();
    const [passed, failed] = state().rows.map(({ checked }) => checked.ok && checked.watch);
    expect(passed).toBeNull();
    const { search, hash } = new URL(failed || "", "https://corridor.example");
    const link = decodeLink(hash.slice(1));
    const run = link.ok ? link.value.run : undefined;
    expect(run?.maze.name).toBe("Maze 2");
    expect(search).toBe(`?from=${Math.max(0, (run?.ticks ?? 0) - 120)}`);
  });

  it("explains the first failure of each program, also where the task hides it from students", async () => {
    const { start, answerAll, state } = setUp();
    const { task } = first;
    const hidden = { ...task, allowed: { ...task.allowed, help: [] } };
    start([rightWall, leftWall], [{ task: hidden, number: 1 }]);
    answerAll();
    await Promise.resolve();
    await Promise.resolve();
    answerAll();
    const causes = state().rows.map(({ checked }) => checked.ok && checked.diagnosis?.cause);
    expect(causes[0]).toBeUndefined();
    expect(causes[1]).not.toBeNull();
  });

  it("fails as a whole if a worker does not load, and can be repeated", () => {
    const { workers, start, answerAll, state } = setUp();
    start([rightWall]);
    workers[0]?.onerror?.({ message: "" } as ErrorEvent);
    expect(state().state).toBe("failed");
    start([rightWall]);
    answerAll();
    expect(state().state).toBe("done");
  });
});

describe("the table as CSV", () => {
  it("has the columns of grade, the number of the hand-in and of an identical one", () => {
    const { start, answerAll, state } = setUp();
    start([rightWall, leftWall, "Anna", rightWall]);
    answerAll();
    const [header, ...lines] = handInsCsv(state().rows).split("\r\n");
    expect(header).toBe(
      "\uFEFFnumber,program,task,passed,code,maze,tick,lines,seconds,unseenCount,unseenPassed,unseenFailed,problem,sameAs",
    );
    expect(lines[0]).toBe("1,line 1,1,true,,,,2,13.367,5,5,,,4");
    expect(lines[1]).toMatch(/^2,line 2,1,false,bump,maze 2,\d+,2,,5,\d,.*,,$/);
    expect(lines[2]).toMatch(/^3,line 3,,false,unreadable,,,,,,,,"?link: found/);
    expect(lines).toHaveLength(5);
  });

  it("escapes the name of a file that looks like a formula", () => {
    const { check, answerAll, state } = setUp();
    const value = { attempt: programOf("right-wall", ""), task: null };
    check.start([first], [{ source: { file: "=1+1.json" }, read: { ok: true, value } }]);
    answerAll();
    expect(handInsCsv(state().rows)).toContain(`1,"'=1+1.json",1,true`);
  });
});
