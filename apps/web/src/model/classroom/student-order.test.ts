import { describe, expect, it } from "vitest";
import type { Standing } from "./standing.ts";
import {
  followOrder,
  helpedOf,
  nextHelped,
  orderOf,
  type OrderedStudent,
  type ShownOrder,
} from "./student-order.ts";

const compareNames = (a: string, b: string): number => (a < b ? -1 : a > b ? 1 : 0);

function student(number: number, standing: Standing, since = 0, name = "", timeMs = 0) {
  return { student: number, name, shown: { standing, since }, timeMs } satisfies OrderedStudent;
}

describe("needs help first", () => {
  it("orders by what a student needs", () => {
    const students = [
      student(1, "not-here"),
      student(2, "solved"),
      student(3, "disconnected"),
      student(4, "working"),
      student(5, "bumped"),
      student(6, "stuck"),
      student(7, "help"),
    ];
    expect(orderOf(students, "help", compareNames)).toEqual([7, 6, 5, 4, 3, 2, 1]);
  });

  it.each<{ standing: Standing }>([
    { standing: "help" },
    { standing: "stuck" },
    { standing: "bumped" },
    { standing: "working" },
    { standing: "disconnected" },
    { standing: "solved" },
  ])("puts the longest $standing first, and equal ones in the order of joining", ({ standing }) => {
    const students = [
      student(1, standing, 300),
      student(2, standing, 100),
      student(4, standing, 200),
      student(3, standing, 200),
    ];
    expect(orderOf(students, "help", compareNames)).toEqual([2, 3, 4, 1]);
  });
});

it("cards can be in the order of names or of time", () => {
  const students = [
    student(1, "help", 0, "Otter", 100),
    student(2, "working", 0, "Basil", 300),
    student(3, "working", 0, "Comet", 200),
  ];
  expect(orderOf(students, "name", compareNames)).toEqual([2, 3, 1]);
  expect(orderOf(students, "time", compareNames)).toEqual([2, 3, 1]);
});

describe("the shown order", () => {
  const shown: ShownOrder = { order: [1, 2, 3], changedAt: 0, waiting: 0 };
  const helped = new Set([3]);

  it.each([
    { what: "waits for 5 s", now: 4_999, isHeld: false, order: [1, 2, 3], waiting: 0 },
    { what: "changes after 5 s", now: 5_000, isHeld: false, order: [3, 1, 2], waiting: 0 },
    {
      what: "never changes under the pointer",
      now: 90_000,
      isHeld: true,
      order: [1, 2, 3],
      waiting: 1,
    },
  ])("$what", ({ now, isHeld, order, waiting }) => {
    expect(followOrder(shown, [3, 1, 2], helped, { now, isHeld })).toMatchObject({
      order,
      waiting,
    });
  });

  it("has a new student last and no removed one, also under the pointer", () => {
    const next = followOrder(shown, [4, 3, 1], new Set(), { now: 1, isHeld: true });
    expect(next).toMatchObject({ order: [1, 3, 4], waiting: 0 });
  });

  it("is the same object while nothing changes", () => {
    expect(followOrder(shown, [1, 2, 3], helped, { now: 9_000, isHeld: false })).toBe(shown);
    const waiting = followOrder(shown, [3, 1, 2], helped, { now: 9_000, isHeld: true });
    expect(followOrder(waiting, [3, 1, 2], helped, { now: 9_500, isHeld: true })).toBe(waiting);
  });
});

it("N goes to the next student who needs help, in a circle", () => {
  const students = [student(1, "working"), student(2, "help"), student(3, "stuck")];
  const helped = helpedOf(students);
  const order = [2, 3, 1];
  expect(nextHelped(order, helped, null)).toBe(2);
  expect(nextHelped(order, helped, 2)).toBe(3);
  expect(nextHelped(order, helped, 3)).toBe(2);
  expect(nextHelped(order, new Set(), 2)).toBeNull();
});
