import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { ClassTime, ToClassroom } from "../../simulator/protocol/classroom-messages.ts";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { Dashboard } from "./dashboard.ts";
import { seenStudent } from "./testing/seen-student.ts";

const START = 1_000_000;
const claim = { code: "x", activeAt: 9_000, lines: 2, attempts: 1 };

beforeEach(() => vi.useFakeTimers({ now: START }));
afterEach(() => vi.useRealTimers());

function newDashboard() {
  const sent: ToClassroom[] = [];
  const verified: number[] = [];
  const dashboard = new Dashboard({
    send: (message) => sent.push(message),
    now: () => Date.now(),
    later: (call, ms) => {
      const timer = setTimeout(call, ms);
      return () => clearTimeout(timer);
    },
    nameOf: ({ student }) => `Team ${student}`,
    compareNames: (a, b) => (a < b ? -1 : 1),
    readPrograms: () => undefined,
    verify: (_lesson, students) => verified.push(students.size),
  });
  const receiveTime = (time: ClassTime): void =>
    dashboard.receive({
      type: "state",
      state: {
        settings: { code: "BCDFGH", locked: false, paceTo: null },
        expected: 3,
        createdAt: START,
        time,
      },
    });
  receiveTime({ at: START, activeMs: 0, pauseEndsAt: null, ahead: 0 });
  const students = (...changed: ReturnType<typeof seenStudent>[]): void =>
    dashboard.receive({ type: "students", changed, removed: [] });
  return {
    dashboard,
    sent,
    verified,
    students,
    receiveTime,
    state: () => dashboard.store.getState(),
    pass: (ms: number): void => void vi.advanceTimersByTime(ms),
  };
}

describe("the dashboard", () => {
  it("puts a student who asks for help first, after 5 s", () => {
    const { students, state, pass } = newDashboard();
    students(seenStudent(1), seenStudent(2));
    students(seenStudent(2, { helpSince: START }));
    expect(state().order.order).toEqual([1, 2]);
    pass(5_000);
    expect(state().order.order).toEqual([2, 1]);
    expect(state().shown.get(2)).toMatchObject({ standing: "help", since: 0 });
  });

  it("puts a student who asks for help first, 5 s after the last change of the order", () => {
    const { students, state, pass } = newDashboard();
    students(seenStudent(1), seenStudent(2), seenStudent(3));
    students(seenStudent(2, { helpSince: START }));
    pass(5_100);
    students(seenStudent(3, { helpSince: START - 1_000 }));
    pass(4_899);
    expect(state().order.order).toEqual([2, 1, 3]);
    pass(1);
    expect(state().order.order).toEqual([3, 2, 1]);
  });

  const paused = { at: START, activeMs: 0, pauseEndsAt: START + 60_000, ahead: 0 };
  it.each<[name: string, begin: (test: ReturnType<typeof newDashboard>) => void]>([
    [
      "a student is disconnected",
      ({ students }) => students(seenStudent(1, { isConnected: false })),
    ],
    [
      "the connection is lost",
      ({ dashboard }) => dashboard.receive({ type: "status", status: { kind: "lost" } }),
    ],
    ["the class is paused", ({ receiveTime }) => receiveTime(paused)],
    ["a student is watched", ({ dashboard }) => dashboard.countSeconds(true)],
  ])("updates at each full second while %s, and otherwise when something changes", (_, begin) => {
    const test = newDashboard();
    const { students, state, pass } = test;
    students(seenStudent(1));
    const updates = (seconds: number): number[] => {
      const times = new Set<number>();
      for (let second = 0; second < seconds; second++) {
        pass(1_000);
        times.add(state().now);
      }
      return [...times].map((at) => at - START);
    };
    expect(updates(30)).toHaveLength(1);
    pass(700);
    begin(test);
    expect(updates(4)).toEqual([31_000, 32_000, 33_000, 34_000]);
  });

  it("moves no card while the pointer or the focus is on one", () => {
    const { dashboard, students, state, pass } = newDashboard();
    students(seenStudent(1), seenStudent(2));
    dashboard.hold("pointer", true);
    dashboard.hold("focus", true);
    students(seenStudent(2, { helpSince: START }));
    dashboard.hold("pointer", false);
    pass(60_000);
    expect(state().order).toMatchObject({ order: [1, 2], waiting: 1 });
    dashboard.sortNow();
    expect(state().order).toMatchObject({ order: [2, 1], waiting: 0 });
  });

  it("has claims verified once the lesson is known, and draws solved paths green", () => {
    const { dashboard, sent, verified, students, state } = newDashboard();
    const task = {
      task: 1,
      openedAt: 0,
      claims: [claim],
      attempts: 1,
      runs: 0,
      bumps: 0,
      failedChecks: 0,
      hints: 0,
      mistakes: 0,
      failures: [],
    };
    students(seenStudent(1, { tasks: [task] }));
    expect(verified).toEqual([]);
    dashboard.receive({ type: "lesson", lesson: sampleLesson, version: "1" });
    expect(verified).toEqual([1]);
    const passes = { kind: "passes", claim, attempt: [] } as const;
    dashboard.verified(new Map([[1, new Map([[1, passes]])]]));
    expect(state().shown.get(1)?.standing).toBe("solved");
    expect(sent.at(-1)).toEqual({ type: "verified", student: 1, tasks: [1] });
    // The student works on the next lesson.
    students(seenStudent(1));
    expect(verified).toEqual([1, 1]);
    dashboard.verified(new Map());
    expect(sent.at(-1)).toEqual({ type: "verified", student: 1, tasks: [] });
  });

  it("knows the version of the lesson, which distinguishes the reports of a class", () => {
    const { dashboard, state } = newDashboard();
    for (const version of ["1", "2"]) {
      dashboard.receive({ type: "lesson", lesson: sampleLesson, version });
      expect(state()).toMatchObject({ lesson: sampleLesson, lessonVersion: version });
    }
  });

  it("knows since when the connection is lost", () => {
    const { dashboard, state, pass } = newDashboard();
    dashboard.receive({ type: "status", status: { kind: "connected" } });
    expect(state().lostAt).toBeNull();
    dashboard.receive({ type: "status", status: { kind: "lost" } });
    pass(9_000);
    dashboard.receive({ type: "status", status: { kind: "connecting" } });
    expect(state().lostAt).toBe(START);
    dashboard.receive({ type: "status", status: { kind: "connected" } });
    expect(state().lostAt).toBeNull();
  });
});
