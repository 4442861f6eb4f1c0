import { lessonMark } from "@corridor/challenge";
import { decodeLink } from "@corridor/link";
import type { ProgramDocument } from "@corridor/program";
import type { Progress } from "@corridor/protocol";
import type { RunDocument } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import type { ClassPlace } from "../../simulator/protocol/class-messages.ts";
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { SimulatorClient } from "../../simulator/simulator-client.ts";
import { createChallengeStore, noChallenge } from "../challenge/challenge-store.ts";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { createRunStore } from "../run/run-store.ts";
import { VolatileStorage } from "../storage/volatile-storage.ts";
import { createWorkspaceStore, setProgram } from "../workspace/workspace-store.ts";
import { ClassLessonMark } from "./class-lesson-mark.ts";
import { LessonReporter } from "./lesson-reporter.ts";
import { ReportedWork } from "./reported-work.ts";

const mark = lessonMark(sampleLesson);
const [firstTask] = sampleLesson.tasks;
if (firstTask?.mazes[0] === undefined) throw new Error("the sample lesson has no maze");
const [maze] = firstTask.mazes;
const forward: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Mine",
  rules: [],
  default: "forward",
};
const reverse: ProgramDocument = { ...forward, default: "reverse" };

/** A page whose class has the sample lesson. */
function newPage(tab = new VolatileStorage()) {
  const challenge = createChallengeStore();
  const workspace = createWorkspaceStore(maze, forward, (_, after) => after);
  const timers = new Set<() => void>();
  const progress: Progress[] = [];
  const programs: { task: number; link: string }[] = [];
  const places: (ClassPlace | null)[] = [];
  const sent: ToWorker[] = [];
  let surveys = 0;
  const simulator = new SimulatorClient({
    postMessage: (message) => sent.push(message),
    onmessage: null,
  });
  const receive = (message: FromWorker) => simulator.catchUp([message]);
  const lesson = new ClassLessonMark(mark);
  const reporter = new LessonReporter({
    challenge,
    workspace,
    run: createRunStore(),
    simulator,
    lesson,
    reported: new ReportedWork(tab),
    add: (event) => progress.push(event),
    setProgram: (task, link) => programs.push({ task, link }),
    setPlace: (place) => places.push(place),
    onAllSolved: () => (surveys += 1),
    later: (call) => {
      timers.add(call);
      return () => void timers.delete(call);
    },
  });
  return {
    tab,
    lesson,
    reporter,
    challenge,
    workspace,
    progress,
    programs,
    place: () => places.at(-1),
    surveys: () => surveys,
    openTask: (index: number) => {
      const solved = sampleLesson.tasks.map(() => false);
      const shown = { lesson: sampleLesson, index, lessonId: mark, solved };
      challenge.setState({ ...noChallenge, ...shown });
    },
    edit: () => setProgram(workspace, reverse, []),
    bump: (tick: number) => {
      const pose = { x: 310, y: 150, heading: 90 };
      const event = { kind: "bump", tick, bumps: 1, line: "default", driver: "program", pose };
      receive({ type: "event", event } as FromWorker);
    },
    /** The robot has driven by hand. */
    drive: (tick: number) => {
      const frame = {
        snapshot: { state: "paused", bumps: 0, pose: { x: 150, y: 150, heading: 0 } },
        view: "now",
        nowDriver: "me",
      };
      receive({ type: "frame", frame: { ...frame, nowTick: tick } } as FromWorker);
    },
    meet: () => {
      const figures = { ticks: 300, bumps: 0, lines: 0 };
      challenge.setState({ result: { state: "met", driver: "program", ...figures } });
    },
    /** A script solves the task. */
    meetByScript: () => {
      const figures = { ticks: 300, bumps: 0, lines: 0 };
      challenge.setState({ result: { state: "met", driver: "remote", ...figures } });
    },
    /** The worker answers the newest request for the run. */
    saveRun: (run: Pick<RunDocument, "program" | "inputs">) => {
      const request = sent.findLast(({ type }) => type === "save-run");
      const saved = { ok: true, text: JSON.stringify(run) };
      receive({ ...request, type: "run-saved", saved } as FromWorker);
    },
    /** The page asks for the robot at its start. */
    requestReset: () => simulator.send({ type: "reset" }),
    reset: () => receive({ type: "truncated", after: -1 }),
    wait: () => {
      for (const call of timers) call();
      timers.clear();
    },
  };
}

describe("the reports of a student's work", () => {
  it("contain each task that opens, once also after a reload", () => {
    const { openTask, progress, tab } = newPage();
    openTask(0);
    openTask(1);
    expect(progress).toEqual([
      { kind: "opened", lesson: mark, task: 1 },
      { kind: "opened", lesson: mark, task: 2 },
    ]);
    const reloaded = newPage(tab);
    reloaded.openTask(1);
    expect(reloaded.progress).toEqual([]);
  });

  it("have no place in a lesson that the teacher has replaced, but still contain its runs", () => {
    const { openTask, lesson, reporter, place, bump, reset, progress } = newPage();
    openTask(0);
    lesson.isReplaced = true;
    reporter.update();
    expect(place()).toBeNull();
    bump(100);
    reset();
    expect(progress.at(-1)).toMatchObject({ kind: "run", task: 1 });
  });

  it("contain that the student drives by hand, until the program is edited", () => {
    const { openTask, drive, edit, place } = newPage();
    openTask(0);
    expect(place()).toMatchObject({ isDriven: false });
    drive(30);
    expect(place()).toMatchObject({ isDriven: true });
    edit();
    expect(place()).toMatchObject({ isDriven: false });
    drive(60);
    expect(place()).toMatchObject({ isDriven: true });
  });

  it("contain runs, and whether the program has changed since the last one", () => {
    const { openTask, bump, reset, edit, progress } = newPage();
    openTask(0);
    for (let run = 0; run < 3; run++) {
      if (run === 2) edit();
      bump(100);
      reset();
    }
    const runs = progress.filter(({ kind }) => kind === "run");
    expect(runs.map((run) => "changed" in run && run.changed)).toEqual([true, false, true]);
    expect(runs[0]).toMatchObject({
      bumps: 1,
      bumpPlaces: [{ maze: "g1", column: 3, row: 1 }],
      failure: { code: "bump", line: "default" },
    });
  });

  it("contain no run of the task before in the next one, whose robot is not at its start yet", () => {
    const { openTask, drive, bump, requestReset, reset, progress } = newPage();
    openTask(0);
    drive(30);
    requestReset();
    openTask(1);
    const before = progress.length;
    drive(60);
    bump(70);
    reset();
    expect(progress.slice(before)).toEqual([]);
    bump(20);
    requestReset();
    reset();
    expect(progress.slice(before)).toMatchObject([{ kind: "run", task: 2, bumps: 1 }]);
  });

  it("contain a run that ends between a reset and its answer", () => {
    const { openTask, drive, bump, requestReset, reset, progress } = newPage();
    openTask(0);
    drive(30);
    requestReset();
    bump(40);
    reset();
    expect(progress.at(-1)).toMatchObject({ kind: "run", task: 1, bumps: 1 });
  });

  it.each([
    {
      failedUnseen: 31,
      contact: { x: 300, y: 150, cell: { column: 3, row: 1 } },
      place: "u31 2 1",
    },
    {
      failedUnseen: null,
      contact: { x: 90, y: 200, cell: { column: 0, row: 1 } },
      place: "g2 0 2",
    },
  ])("contain where a check bumped: $place", ({ failedUnseen, contact, place }) => {
    const { openTask, challenge, progress } = newPage();
    openTask(1);
    const bumped = { event: { kind: "bump", line: 0, contact }, cause: null } as never;
    const failure = { code: "bump", maze: failedUnseen === null ? 1 : null, line: 0 } as never;
    challenge.setState({
      diagnoses: [null, failedUnseen === null ? bumped : null],
      unseenDiagnosis: failedUnseen === null ? null : bumped,
      checked: { passed: false, failure, failedUnseen, unseenFailures: [], mazes: [] },
    });
    const [maze = "", column, row] = place.split(" ");
    const bumpPlaces = [{ maze, column: Number(column), row: Number(row) }];
    expect(progress.at(-1)).toMatchObject({ kind: "check", bumpPlaces });
  });

  it("contain a solution after its run, and not again", () => {
    const { openTask, meet, challenge, progress } = newPage();
    openTask(0);
    meet();
    challenge.setState({ result: { state: "open" } });
    meet();
    const solved = progress.filter(({ kind }) => kind === "solved");
    expect(solved).toHaveLength(1);
    const [{ code } = { code: "" }] = solved.flatMap((each) =>
      each.kind === "solved" ? [each] : [],
    );
    expect(decodeLink(code ?? "")).toMatchObject({
      ok: true,
      value: { completion: { lesson: mark, task: 0 } },
    });
  });

  it("contain a solution by a script in several mazes without a code", () => {
    const { openTask, meetByScript, progress } = newPage();
    openTask(1);
    expect(sampleLesson.tasks[1]?.mazes.length).toBeGreaterThan(1);
    meetByScript();
    expect(progress.at(-1)).toEqual({ kind: "solved", task: 2, lines: null, code: null });
  });

  it.each([
    ["with its commands", 0, (code: string | null) => decodeLink(code ?? "").ok],
    ["without a code after a program has driven", 10, (code: string | null) => code === null],
  ])("contain a solution by a script, %s", (_, tick, isExpected) => {
    const { openTask, meetByScript, saveRun, progress } = newPage();
    openTask(0);
    meetByScript();
    saveRun({
      program: forward,
      inputs: [
        { tick, do: "driver", driver: "remote" },
        { tick, do: "command", command: { action: "forward" } },
      ],
    });
    const solved = progress.find((event) => event.kind === "solved");
    expect(solved).toMatchObject({ task: 1, lines: null });
    expect(isExpected(solved?.code ?? null)).toBe(true);
  });

  it("contain the program without its name, some time after an edit", () => {
    const { openTask, edit, wait, programs } = newPage();
    openTask(0);
    edit();
    expect(programs).toEqual([]);
    wait();
    expect(programs).toHaveLength(1);
    const read = decodeLink(programs[0]?.link ?? "");
    expect(read).toMatchObject({ ok: true, value: { program: { name: "", default: "reverse" } } });
  });

  it("say where the student is, and nothing of other work", () => {
    const { openTask, challenge, place, bump, edit, wait, progress, programs } = newPage();
    openTask(0);
    expect(place()).toEqual({
      task: 1,
      maze: "g1",
      passes: null,
      isSolved: false,
      isDriven: false,
    });
    challenge.setState({ ...noChallenge });
    expect(place()).toBeNull();
    const before = progress.length;
    edit();
    bump(100);
    wait();
    expect(progress).toHaveLength(before);
    expect(programs).toEqual([]);
  });

  it("lead to the survey once all tasks are solved", () => {
    const { openTask, challenge, surveys } = newPage();
    openTask(0);
    challenge.setState({ solved: [true, true, false] });
    expect(surveys()).toBe(0);
    challenge.setState({ solved: [true, true, true] });
    expect(surveys()).toBe(1);
  });

  it("end with the class", () => {
    const { openTask, reporter, bump, reset, progress } = newPage();
    openTask(0);
    bump(100);
    reporter.close();
    reset();
    openTask(1);
    expect(progress).toEqual([{ kind: "opened", lesson: mark, task: 1 }]);
  });
});
