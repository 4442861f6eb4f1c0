import { describe, expect, it } from "vitest";
import { Dashboard } from "../../model/classroom/dashboard.ts";
import { seenStudent } from "../../model/classroom/testing/seen-student.ts";
import { emptyTask } from "../../simulator/classroom-worker/student-work.ts";
import type { ClassTime, SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { cardState, cardTime } from "./use-card.ts";

const START = 1_000_000;
const OPENED = 5_000;

/** A class with one student, a while after it has started. */
function classAfter(ms: number, change: Partial<ClassTime> = {}, isSolved = false) {
  const dashboard = new Dashboard({
    send: () => undefined,
    now: () => START + ms,
    later: () => () => undefined,
    nameOf: () => "",
    compareNames: () => 0,
    readPrograms: () => undefined,
    verify: () => undefined,
  });
  const student: SeenStudent = seenStudent(1, {
    tasks: [{ ...emptyTask(1), openedAt: OPENED }],
  });
  dashboard.receive({ type: "students", changed: [student], removed: [] });
  const time = { at: START, activeMs: 0, pauseEndsAt: null, ahead: 0, ...change };
  dashboard.receive({
    type: "state",
    state: {
      settings: { code: "BCDFGH", locked: false, paceTo: null },
      expected: null,
      createdAt: START,
      time,
    },
  });
  const claim = { code: "x", activeAt: OPENED + 62_000, lines: 2, attempts: 1 };
  const passes = { kind: "passes", claim, attempt: [] } as const;
  if (isSolved) dashboard.verified(new Map([[1, new Map([[1, passes]])]]));
  return [dashboard.store.getState(), student] as const;
}

function timeAfter(...after: Parameters<typeof classAfter>) {
  return cardTime(...classAfter(...after));
}

describe("the time on a card", () => {
  it("runs from the moment at which the student opened the task", () => {
    const running = { minutes: 0, startedAt: START + OPENED, seconds: 0 };
    expect(timeAfter(6_000)).toEqual(running);
    expect(timeAfter(64_999)).toEqual(running);
    expect(timeAfter(65_000)).toEqual(running);
  });

  it("stands while the class is paused, and is later by the pause", () => {
    const pause = { at: START + 10_000, activeMs: 10_000, pauseEndsAt: START + 30_000 };
    expect(timeAfter(20_000, pause)).toEqual({ minutes: 0, startedAt: null, seconds: 5 });
    expect(timeAfter(31_000, pause)).toEqual({
      minutes: 0,
      startedAt: START + OPENED + 20_000,
      seconds: 0,
    });
  });

  it("stands after the first verified solution", () => {
    expect(timeAfter(600_000, {}, true)).toEqual({ minutes: 1, startedAt: null, seconds: 2 });
  });
});

describe("the state on a card", () => {
  const pause = { at: START, activeMs: 0, pauseEndsAt: START + 30_000 };

  it("is paused in a pause of the class, in which nobody can write", () => {
    expect(cardState(...classAfter(29_000, pause))).toBe("paused");
    expect(cardState(...classAfter(31_000, pause))).toBe("writing");
  });

  it("is still solved in a pause", () => {
    expect(cardState(...classAfter(29_000, pause, true))).toBe("solved");
  });
});
