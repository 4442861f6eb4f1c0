import type { Judgement, LessonTask } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import { describe, expect, it } from "vitest";
import { FakePoolWorker } from "../../simulator/testing/fake-pool-worker.ts";
import { WorkerPool } from "../../simulator/worker-pool.ts";
import { RunJudge } from "../../simulator/worker/run-judge.ts";
import { RunLoop } from "../../simulator/worker/run-loop.ts";
import { noChallenge, openTask } from "../challenge/challenge-store.ts";
import { setProgram } from "../workspace/workspace-store.ts";
import { Attempt } from "./attempt.ts";
import { LessonsNavigation } from "./lessons-navigation.ts";
import { LessonsProgress } from "./lessons-progress.ts";
import { lines, type MissionId } from "./missions/mission.ts";
import { ProgramCheck } from "./program-check.ts";
import { sampleLesson, sampleTask } from "./testing/sample-lesson.ts";
import { StoredLessons } from "./stored-lessons.ts";
import { lessonsPage, noAddressBar } from "./testing/lessons-page.ts";

/** A page with an open mission, its robot, and the check in this thread. */
function openMission(id: MissionId) {
  const { ports, challenge, workspace, storage, device, sent, report } = lessonsPage();
  const worker = new FakePoolWorker();
  const check = new ProgramCheck(new WorkerPool(() => worker, 1), () => undefined);
  const lessons = new StoredLessons(device);
  const attempt = new Attempt(ports, new LessonsProgress(ports), lessons, check);
  const navigation = new LessonsNavigation(ports, attempt, lessons, noAddressBar);
  navigation.openMission(id);
  const open = openTask(challenge.getState());
  if (open === null) throw new Error("no challenge");
  let time = 0;
  const loop = new RunLoop(workspace.getState().maze, workspace.getState().program, () => time);
  loop.updates.judgeBy(new RunJudge(open, 0));
  const judge = (judgement: Judgement): void => {
    const judgeId = sent.findLast((message) => message.type === "judge")?.id ?? 0;
    report({ type: "judgement", id: judgeId, judgement });
  };
  return {
    attempt,
    progress: () => check.progress.getState(),
    stopCheck: () => check.stop(),
    /** Runs what the check needs next. @returns false if it needs nothing */
    answer: () => worker.answer(),
    answerAll: () => {
      while (worker.answer());
    },
    navigation,
    challenge,
    storage,
    sent,
    report,
    reportLate: () => {
      const { program } = workspace.getState();
      report({ type: "diagnosed", diagnosis: lateAt(1201), program });
    },
    judge,
    clock: () => loop.snapshot().tick,
    program: (program: ReturnType<typeof lines>) => {
      setProgram(workspace, program);
      loop.editProgram(program);
    },
    /** Runs the program, and reports a new judgement. */
    drive: (seconds: number) => {
      loop.run();
      for (const end = time + 1000 * seconds; time < end;) {
        time += 8;
        loop.advance();
      }
      const judgement = loop.updates.takeJudgement();
      if (judgement !== null) judge(judgement);
    },
  };
}

const nearWall = { sensor: "front", is: "<", than: 50 } as const;
const wavering = lines("forward", { when: nearWall, do: "reverse" });
const solving = lines("forward", { when: nearWall, do: "turn 180" });

describe("the figures of a solved mission", () => {
  it("are those of the run on the screen if the program was edited during it", () => {
    const page = openMission("one-line");
    page.program(wavering);
    page.drive(6);
    page.program(solving);
    page.drive(10);
    page.answerAll();
    expect(page.challenge.getState().result.state).toBe("met");
    const ticks = page.clock();
    expect(page.challenge.getState().result).toMatchObject({ ticks, bumps: 0, lines: 1 });
    // The best result is that of the program from the start.
    const best = page.storage.record.done["one-line"]?.ticks ?? 0;
    expect(best).toBeGreaterThan(0);
    expect(best).toBeLessThan(ticks - 200);
  });

  it("are equally those of the check if the program drove from the start", () => {
    const page = openMission("one-line");
    page.program(solving);
    page.drive(10);
    page.answerAll();
    expect(page.challenge.getState().result.state).toBe("met");
    const ticks = page.clock();
    expect(page.challenge.getState().result).toMatchObject({ ticks });
    expect(page.storage.record.done["one-line"]).toEqual({ lines: 1, ticks });
  });
});

const lateAt = (tick: number): Diagnosis => ({
  event: { kind: "late", tick },
  cause: null,
  fixes: [],
});

describe("the verdict of a failed run", () => {
  /** A page whose program ran out of time. */
  function late() {
    const page = openMission("one-line");
    page.reportLate();
    page.judge({ kind: "failed", code: "late", tick: 1201 });
    return page;
  }

  it("is withdrawn with its cause when the run ends, and never stands without it", () => {
    const page = late();
    expect(page.challenge.getState()).toMatchObject({ failedRun: lateAt(1201) });
    page.report({ type: "truncated", after: -1 });
    expect(page.challenge.getState()).toMatchObject({ failedRun: null, result: { state: "open" } });
  });

  it("stays with its cause if the run goes on from a later tick", () => {
    const page = late();
    page.report({ type: "truncated", after: 1300 });
    expect(page.challenge.getState()).toMatchObject({
      failedRun: lateAt(1201),
      result: { state: "failed" },
    });
  });

  it("ends before another maze opens, which is not judged by it", () => {
    const page = openMission("every-maze");
    page.reportLate();
    page.sent.length = 0;
    page.navigation.showMaze(1);
    expect(page.sent.map(({ type }) => type)).toEqual(["reset", "judge"]);
    expect(page.challenge.getState()).toMatchObject({ failedRun: null, result: { state: "open" } });
  });
});

describe("the marks of the mazes", () => {
  const failed = { checked: { passed: false }, verdict: null };

  /** A page whose program has passed or failed a check of all mazes. */
  async function checked(program: ReturnType<typeof lines>) {
    const page = openMission("every-maze");
    page.program(program);
    const ended = page.attempt.check();
    page.answerAll();
    await ended;
    return page;
  }
  const rightWall = lines(
    "forward",
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: nearWall, do: "left 90" },
  );

  it("stay when a run of the same program fails, whose reason is the newer verdict", async () => {
    const page = await checked(wavering);
    page.report({ type: "diagnosed", diagnosis: lateAt(1201), program: wavering });
    expect(page.challenge.getState()).toMatchObject({ ...failed, failedRun: lateAt(1201) });
  });

  it("end when the program changes", async () => {
    const page = await checked(wavering);
    page.program(solving);
    expect(page.challenge.getState().checked).toBeNull();
  });

  it("keep a program solved that runs again in another maze", async () => {
    const page = await checked(rightWall);
    expect(page.challenge.getState().result.state).toBe("met");
    page.navigation.showMaze(1);
    expect(page.challenge.getState().result.state).toBe("open");
    page.judge({ kind: "met", driver: "program", tick: 700, bumps: 0 });
    expect(page.challenge.getState()).toMatchObject({
      result: { state: "met" },
      checked: { passed: true },
    });
  });
});

describe("a task of a lesson", () => {
  const unseen = { kind: "tree", columns: 5, rows: 5, seed: 1, count: 1, pass: 1 } as const;

  function openTaskWith(change: Partial<LessonTask>) {
    const page = openMission("make-it-move");
    const first = { ...sampleTask("make-it-move", "Drive"), ...change };
    const lesson = { ...sampleLesson, tasks: [first, ...sampleLesson.tasks] };
    page.navigation.openShared(lesson, null);
    return { ...page, lesson };
  }

  it("is stored as solved when it is met", () => {
    const page = openTaskWith({});
    page.judge({ kind: "met", driver: "me", tick: 240, bumps: 0 });
    expect(page.challenge.getState()).toMatchObject({
      result: { state: "met" },
      solved: [true, false, false, false],
    });
    page.navigation.goHome();
    page.navigation.openShared(page.lesson, null);
    expect(page.challenge.getState().solved).toEqual([true, false, false, false]);
  });

  it("with unseen mazes is not solved by a drive by hand in a given one", () => {
    const page = openTaskWith({ unseen });
    page.judge({ kind: "met", driver: "me", tick: 240, bumps: 0 });
    expect(page.challenge.getState()).toMatchObject({
      result: { state: "here", driver: "me" },
      solved: [false, false, false, false],
    });
  });

  it("with several mazes is solved by hand once each of them is", () => {
    const { mazes } = sampleTask("every-maze", "Drive");
    const page = openTaskWith({ mazes });
    const met: Judgement = { kind: "met", driver: "me", tick: 240, bumps: 0 };
    page.judge(met);
    page.judge(met);
    expect(page.challenge.getState()).toMatchObject({
      result: { state: "here" },
      drivenMazes: [0],
    });
    for (const maze of mazes.keys()) {
      page.navigation.showMaze(maze);
      page.judge(met);
    }
    expect(page.challenge.getState()).toMatchObject({
      result: { state: "met", driver: "me" },
      solved: [true, false, false, false],
    });
    page.navigation.goHome();
    page.navigation.openShared(page.lesson, null);
    expect(page.challenge.getState().drivenMazes).toEqual([]);
  });
});

describe("a check", () => {
  it("that is stopped keeps what it has found, and decides nothing", async () => {
    const page = openMission("every-maze");
    page.program(wavering);
    const ended = page.attempt.check();
    expect(page.challenge.getState().isChecking).toBe(true);
    page.answer();
    page.stopCheck();
    await ended;
    expect(page.progress()).toMatchObject({ state: "stopped", done: 1, count: 3 });
    expect(page.challenge.getState()).toMatchObject({
      isChecking: false,
      checked: null,
      result: { state: "open" },
    });
  });

  it("ends without a verdict when the program changes, also while its failures are diagnosed", async () => {
    for (const answers of [1, 4]) {
      const page = openMission("every-maze");
      page.program(wavering);
      const ended = page.attempt.check();
      for (let each = 0; each < answers; each++) page.answer();
      page.program(solving);
      page.answerAll();
      await ended;
      expect(page.progress().state).toBe("idle");
      expect(page.challenge.getState()).toMatchObject({ isChecking: false, checked: null });
    }
  });

  it("is still known after a visit to another maze with the same program", async () => {
    const page = openMission("every-maze");
    page.program(wavering);
    const ended = page.attempt.check();
    page.answerAll();
    await ended;
    // The page closes the task of a project before another project opens.
    page.challenge.setState(noChallenge);
    page.navigation.sync();
    expect(page.progress()).toMatchObject({ state: "done", count: 3 });
  });
});
