import type { Tile } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { Roster } from "./roster.ts";
import { classView, record, studentView } from "./testing/class-of.ts";

const NOW = 900_000;
const tile: Tile = {
  seq: 1,
  task: 1,
  maze: "g1",
  state: "driving",
  pose: [150, 250, 90],
  path: "e2",
  line: 0,
  tick: 60,
  bumps: 0,
  passes: null,
};

/** A roster with these students, whose first changes were taken. */
function rosterOf(...students: number[]): Roster {
  return rosterAt(() => NOW, ...students);
}

/** @param activeMs the active time now */
function rosterAt(activeMs: () => number, ...students: number[]): Roster {
  const roster = new Roster(activeMs);
  roster.replace(classView(students.map((each) => ({ ...studentView(each), progress: [] }))));
  roster.takeChanges();
  return roster;
}

describe("the students of a class", () => {
  it("are those of the class when it was read", () => {
    const roster = rosterOf(1, 2);
    const opened = record(1, 60_000, { kind: "opened", lesson: "0123456ab", task: 2 });
    roster.replace(classView([{ ...studentView(2), progress: [opened] }]));
    const { changed, removed } = roster.takeChanges();
    expect(removed).toEqual([1]);
    expect(changed).toMatchObject([{ student: 2, busyAt: 60_000, tasks: [{ task: 2 }] }]);
    expect(roster.hasChanges).toBe(false);
  });

  it("join, change and are removed by events", () => {
    const roster = rosterOf();
    const student = studentView(1);
    roster.follow({ type: "student", n: 5, student, progress: null });
    expect(roster.takeChanges().changed).toMatchObject([{ student: 1, busyAt: NOW }]);
    roster.follow({ type: "removed", n: 6, student: 1 });
    expect(roster.takeChanges()).toEqual({ changed: [], removed: [1] });
  });

  it("count each progress record once", () => {
    const roster = rosterOf(1);
    const hint = record(1, 1, { kind: "hint", task: 1, hint: 1 });
    const event = { type: "student", n: 5, student: studentView(1), progress: hint } as const;
    roster.follow(event);
    roster.follow(event);
    expect(roster.takeChanges().changed).toMatchObject([{ tasks: [{ hints: 1 }] }]);
  });

  it("have edited when a program was stored", () => {
    const roster = new Roster(() => NOW);
    const opened = record(1, 60_000, { kind: "opened", lesson: "0123456ab", task: 1 });
    roster.replace(classView([{ ...studentView(1), progress: [opened] }]));
    const student = studentView(1, { programs: 1 });
    roster.follow({ type: "student", n: 5, student, progress: null });
    expect(roster.takeChanges().changed).toMatchObject([{ busyAt: NOW }]);
  });

  it("are busy while their robots drive, which the page learns every 30 s", () => {
    let now = NOW;
    const roster = rosterAt(() => now, 1);
    const busyAt: number[] = [];
    for (let second = 0; second <= 300; second += 1) {
      now = NOW + second * 1_000;
      const driven: Tile = { ...tile, seq: second + 1, tick: (second + 1) * 60 };
      roster.show([{ student: 1, connected: true, tile: driven }]);
      busyAt.push(...roster.takeChanges().changed.map((each) => each.busyAt));
    }
    expect(busyAt).toEqual(Array.from({ length: 11 }, (_, at) => NOW + at * 30_000));
  });

  it("start all counts again with the tile of another task, before its record arrives", () => {
    let now = NOW;
    const roster = rosterAt(() => now, 1);
    roster.show([{ student: 1, connected: true, tile }]);
    now += 600_000;
    roster.show([{ student: 1, connected: true, tile: { ...tile, seq: 2, task: 2 } }]);
    expect(roster.takeChanges().changed).toMatchObject([{ busyAt: now, bestAt: now, repeats: 0 }]);
  });

  it("start all counts again with another lesson, also if the class is read again", () => {
    let now = NOW;
    const roster = rosterAt(() => now, 1);
    const bumped = (seq: number) =>
      record(seq, 60_000, {
        kind: "run",
        task: 1,
        changed: true,
        bumps: 1,
        mistakes: 0,
        failure: { code: "bump", line: 0 },
      });
    const view = classView([{ ...studentView(1), progress: [1, 2, 3, 4].map(bumped) }]);
    roster.replace(view);
    expect(roster.takeChanges().changed).toMatchObject([{ repeats: 4 }]);
    now += 200_000;
    roster.restart();
    const fresh = [{ busyAt: now, bestAt: now, repeats: 0 }];
    expect(roster.takeChanges().changed).toMatchObject(fresh);
    roster.replace(view);
    expect(roster.takeChanges().changed).toMatchObject(fresh);
  });

  it("have only their work in the lesson of the class, also before they open it", () => {
    const roster = rosterOf();
    const opened = { kind: "opened", lesson: "0123456ab", task: 1 } as const;
    const hint = { kind: "hint", task: 1, hint: 1 } as const;
    const survey = { kind: "survey", answers: [{ id: "navigation", answer: 5 }] } as const;
    const progress = [opened, hint, { ...survey, answers: [...survey.answers] }].map((event, at) =>
      record(at + 1, 60_000, event),
    );
    roster.replace(classView([1, 2].map((each) => ({ ...studentView(each), progress }))));
    roster.setLesson("0123456ab");
    roster.watch(1);
    roster.show([{ student: 1, connected: true, tile }]);
    const worked = { tasks: [{ task: 1, hints: 1 }], answers: { navigation: 5 } };
    expect(roster.takeChanges().changed).toMatchObject([worked, worked]);

    roster.setLesson("0123456cd");
    const nothing = { tasks: [], recent: [], answers: null };
    expect(roster.takeChanges().changed).toMatchObject([nothing, nothing]);
    const open = record(4, 120_000, { ...opened, lesson: "0123456cd" });
    roster.follow({ type: "student", n: 5, student: studentView(2), progress: open });
    const begun = { student: 2, tasks: [{ openedAt: 120_000, hints: 0 }], answers: null };
    expect(roster.takeChanges().changed).toMatchObject([begun]);

    // The class has the first lesson again: only one student has it open.
    roster.setLesson("0123456ab");
    expect(roster.takeChanges().changed).toMatchObject([worked, worked]);
  });

  it("change on the page only if the words of the card do", () => {
    const roster = rosterOf(1);
    roster.show([{ student: 1, connected: true, tile }]);
    expect(roster.takeChanges().changed).toMatchObject([{ isConnected: true }]);
    const moved: Tile = { ...tile, seq: 2, pose: [250, 250, 90], tick: 90 };
    expect(roster.show([{ student: 1, connected: true, tile: moved }])).toEqual([1]);
    expect(roster.hasChanges).toBe(false);
    expect(roster.tileOf(1)).toEqual(moved);
  });

  it("show their running line while the teacher watches them", () => {
    const roster = rosterOf(1, 2);
    for (const student of [1, 2]) roster.show([{ student, connected: true, tile }]);
    roster.takeChanges();
    const next: Tile = { ...tile, seq: 2, line: 1 };
    roster.watch(2);
    expect(roster.takeChanges().changed).toMatchObject([{ student: 2, tile: { line: 0 } }]);
    for (const student of [1, 2]) roster.show([{ student, connected: true, tile: next }]);
    expect(roster.takeChanges().changed).toMatchObject([{ student: 2, tile: { line: 1 } }]);
  });

  it("show their newest attempts while the teacher watches them", () => {
    const roster = rosterOf(1);
    const failure = { code: "bump", line: 0 };
    const run = { kind: "run", task: 1, changed: true, bumps: 1, mistakes: 0, failure } as const;
    const check = { kind: "check", task: 1, changed: true, passes: 3, mazes: 5 } as const;
    const follow = (progress: ReturnType<typeof record>) =>
      roster.follow({ type: "student", n: progress.seq, student: studentView(1), progress });
    follow(record(1, 2_000, run));
    expect(roster.takeChanges().changed).toMatchObject([{ recent: [] }]);
    roster.watch(1);
    follow(record(2, 3_000, { ...check, failure: null }));
    const newest = { seq: 2, task: 1, at: 3_000, check: { passes: 3, mazes: 5 }, failure: null };
    const before = { seq: 1, task: 1, at: 2_000, check: null, failure };
    expect(roster.takeChanges().changed).toMatchObject([{ recent: [newest, before] }]);
  });

  it("have their bumps counted where the robots were, also those before the dashboard opened", () => {
    const roster = rosterOf(1, 2);
    expect(roster.takeBumps()).toBeNull();
    const opened = { kind: "opened", lesson: "0123456ab", task: 1 } as const;
    const place = { maze: "g1", column: 1, row: 2 };
    const run = (...bumpPlaces: (typeof place)[]) =>
      ({
        kind: "run",
        task: 1,
        changed: true,
        bumps: bumpPlaces.length,
        bumpPlaces,
        mistakes: 0,
        failure: null,
      }) as const;
    const progress = [record(1, 1_000, opened), record(2, 2_000, run(place, place))];
    roster.replace(
      classView([
        { ...studentView(1), progress },
        { ...studentView(2), progress },
      ]),
    );
    expect(roster.takeBumps()).toEqual([{ task: 1, ...place, count: 4 }]);
    expect(roster.takeBumps()).toBeNull();
    const other = { ...place, maze: "g2" };
    const next = record(3, 3_000, run(other));
    roster.follow({ type: "student", n: 5, student: studentView(1), progress: next });
    expect(roster.takeBumps()).toEqual([
      { task: 1, ...place, count: 4 },
      { task: 1, ...other, count: 1 },
    ]);
    // A record that arrives again changes nothing.
    roster.follow({ type: "student", n: 6, student: studentView(1), progress: next });
    expect(roster.takeBumps()).toBeNull();
    // The class has another lesson, whose tasks have the same numbers, and one student opens it.
    roster.setLesson("0123456cd");
    expect(roster.takeBumps()).toEqual([]);
    const lesson = record(3, 4_000, { ...opened, lesson: "0123456cd" });
    roster.follow({ type: "student", n: 7, student: studentView(2), progress: lesson });
    expect(roster.takeBumps()).toEqual([]);
    roster.follow({ type: "removed", n: 8, student: 2 });
    expect(roster.takeBumps()).toEqual([]);
    roster.setLesson("0123456ab");
    expect(roster.takeBumps()).toEqual([
      { task: 1, ...place, count: 2 },
      { task: 1, ...other, count: 1 },
    ]);
  });

  it("have their bumps counted as soon as a tile contains them, and only once", () => {
    const roster = rosterOf(1);
    const opened = record(1, 1_000, { kind: "opened", lesson: "0123456ab", task: 1 });
    roster.follow({ type: "student", n: 5, student: studentView(1), progress: opened });
    roster.takeBumps();
    const show = (change: Partial<Tile>) =>
      roster.show([{ student: 1, connected: true, tile: { ...tile, ...change } }]);
    show({ tick: 60 });
    expect(roster.takeBumps()).toBeNull();
    show({ tick: 90, state: "bumped", bumps: 1, pose: [312, 250, 90] });
    const place = { task: 1, maze: "g1", column: 3, row: 2 };
    expect(roster.takeBumps()).toEqual([{ ...place, count: 1 }]);
    show({ tick: 90, state: "bumped", bumps: 1, pose: [312, 250, 90], line: null });
    expect(roster.takeBumps()).toBeNull();
    const exact = { maze: "g1", column: 3, row: 3 };
    const run = { kind: "run", task: 1, changed: true, bumps: 1, mistakes: 0 } as const;
    const failure = { code: "bump", line: 0 };
    const progress = record(2, 2_000, { ...run, bumpPlaces: [exact], failure });
    roster.follow({ type: "student", n: 6, student: studentView(1), progress });
    expect(roster.takeBumps()).toEqual([{ task: 1, ...exact, count: 1 }]);
  });

  it("count the bumps of checks, also in unseen mazes", () => {
    const roster = rosterOf(1);
    const bumpPlaces = [{ maze: "u31", column: 4, row: 2 }];
    const failure = { code: "bump", line: 0 };
    const check = { kind: "check", task: 2, changed: true, passes: 3, mazes: 51 } as const;
    const progress = record(1, 1_000, { ...check, bumpPlaces, failure });
    roster.follow({ type: "student", n: 5, student: studentView(1), progress });
    expect(roster.takeBumps()).toEqual([{ task: 2, ...bumpPlaces[0], count: 1 }]);
  });

  it("have a run and an attempt as soon as the robot drives, also if a pause stops it", () => {
    const roster = rosterOf(1);
    const counts = () => roster.takeChanges().changed.map(({ tasks }) => tasks);
    const show = (change: Partial<Tile>) =>
      roster.show([{ student: 1, connected: true, tile: { ...tile, ...change } }]);
    show({ tick: 0, state: "writing" });
    expect(counts()).toEqual([[]]);
    show({ tick: 60 });
    expect(counts()).toMatchObject([[{ task: 1, runs: 1, attempts: 1 }]]);
    show({ tick: 60, state: "writing" });
    expect(counts()).toMatchObject([[{ task: 1, runs: 1, attempts: 1 }]]);
    const run = { kind: "run", task: 1, changed: true, bumps: 0, mistakes: 0 } as const;
    const progress = record(1, 2_000, { ...run, failure: null });
    roster.follow({ type: "student", n: 5, student: studentView(1), progress });
    expect(counts()).toMatchObject([[{ task: 1, runs: 1, attempts: 1 }]]);
  });

  it("ignore tiles of students who were removed", () => {
    expect(rosterOf(1).show([{ student: 7, connected: true, tile }])).toEqual([]);
  });
});
