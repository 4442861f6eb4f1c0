/** The rules of a class, without a store or a relay. */
import { MAX_STUDENTS, NAME_WORDS } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Refusal } from "../platform/errors/problems.ts";
import { hashKey } from "../platform/keys.ts";
import type { ClassRecord } from "../bus/class-record.ts";
import type { ClassRow } from "../store/class-store.ts";
import { classRow } from "../store/testing/class-row.ts";
import { applied, pausedMs, settingsOf, type ClassState } from "./class-state.ts";
import type { Step } from "./step.ts";
import {
  helpStep,
  joinStep,
  programStep,
  progressStep,
  renameStep,
  returnStep,
} from "./student-steps.ts";
import {
  lockStep,
  newCodeStep,
  paceStep,
  pauseStep,
  removeStep,
  resumeStep,
  returnCodeStep,
} from "./teacher-steps.ts";

const CODE = "BCDFGH";

function newClass(change: Partial<ClassRow> = {}): ClassState {
  return { row: classRow({ code: CODE, lessonVersion: "v", ...change }), students: new Map() };
}

/** A class that steps change, at the time `now`. */
function classOf(state: ClassState) {
  const held = { state, now: 0 };
  let codes = 0;
  const events: ClassRecord[] = [];
  const run = <T>(step: Step<T>): T => {
    const context = {
      now: held.now,
      mintCode: () => `CODE-${(codes += 1)}`,
      random: (below: number) => Math.max(0, below - 1),
    };
    const result = step(held.state, context);
    if (result.changes !== null) held.state = applied(held.state, result.changes);
    events.push(...result.events);
    return result.value;
  };
  return {
    held,
    events,
    run,
    join: (key: string) => run(joinStep(key, hashKey(held.state.row.code))),
  };
}

const refused = (kind: string) => expect.objectContaining({ kind });

describe("joining a class", () => {
  it("numbers the students and gives each another word", () => {
    const { held, join } = classOf(newClass());
    expect(join("a")).toEqual({ student: 1, name: { word: NAME_WORDS - 1, text: null } });
    expect(join("b")).toEqual({ student: 2, name: { word: NAME_WORDS - 2, text: null } });
    expect(held.state.row.n).toBe(2);
  });

  it("gives the teacher's pseudonyms, and is full without a free one", () => {
    const { run, join } = classOf(newClass({ names: ["Ada", "Bo"] }));
    expect([join("a"), join("b")].map(({ name }) => name.text)).toEqual(["Bo", "Ada"]);
    expect(() => join("c")).toThrow(refused("class-full"));
    run(removeStep(1));
    expect(join("c")).toEqual({ student: 3, name: { word: null, text: "Bo" } });
  });

  it("is full with 200 students", () => {
    const { join } = classOf(newClass());
    for (let n = 1; n <= MAX_STUDENTS; n++) join(`key ${n}`);
    expect(() => join("one more")).toThrow(refused("class-full"));
  });

  it("is not possible while the class is locked", () => {
    const { run, join } = classOf(newClass());
    run(lockStep(true));
    expect(() => join("a")).toThrow(refused("class-locked"));
    run(lockStep(false));
    expect(join("a").student).toBe(1);
  });

  it("locks the class when as many have joined as expected, until the teacher unlocks it", () => {
    const { held, run, join } = classOf(newClass({ expected: 2 }));
    join("a");
    expect(held.state.row.isLocked).toBe(false);
    join("b");
    expect(held.state.row.isLocked).toBe(true);
    expect(() => join("c")).toThrow(refused("class-locked"));
    run(lockStep(false));
    expect(join("c").student).toBe(3);
  });

  it("is not possible with a code that the teacher has replaced", () => {
    const { run } = classOf(newClass());
    expect(run(newCodeStep())).toBe("CODE-1");
    expect(() => run(joinStep("a", hashKey(CODE)))).toThrow(refused("no-class"));
    expect(run(joinStep("a", hashKey("CODE-1"))).student).toBe(1);
  });

  it("never gives one name or number to two students", () => {
    const action = fc.oneof(
      { weight: 3, arbitrary: fc.constant("join") },
      fc.record({ remove: fc.integer({ min: 1, max: 20 }) }),
    );
    fc.assert(
      fc.property(fc.array(action, { maxLength: 60 }), (actions) => {
        const { held, run, join } = classOf(newClass({ names: ["A", "B", "C", "D", "E"] }));
        const numbers: number[] = [];
        for (const each of actions) {
          try {
            if (typeof each === "string") numbers.push(join("key").student);
            else run(removeStep(each.remove));
          } catch (error) {
            if (!(error instanceof Refusal)) throw error;
          }
          const names = [...held.state.students.values()].map(({ name }) => name);
          expect(new Set(names).size).toBe(names.length);
        }
        expect(new Set(numbers).size).toBe(numbers.length);
      }),
    );
  });
});

type Room = ReturnType<typeof classOf>;

describe("a return code", () => {
  const RETURN = hashKey("CODE-1");

  it("makes another device the student once, also while the class is locked", () => {
    const { held, run, join } = classOf(newClass());
    const { name } = join("old key");
    run(lockStep(true));
    expect(run(returnCodeStep(1))).toEqual({ code: "CODE-1", seconds: 600 });
    expect(run(returnStep(1, "new key", RETURN))).toEqual({ student: 1, name });
    expect(held.state.students.get(1)?.key).toBe("new key");
    expect(() => run(returnStep(1, "third key", RETURN))).toThrow(refused("no-class"));
  });

  it.each([
    {
      when: "10 minutes have passed",
      act: ({ held }: ReturnType<typeof classOf>) => (held.now = 600_000),
    },
    {
      when: "there is a newer one",
      act: ({ run }: ReturnType<typeof classOf>) => run(returnCodeStep(1)),
    },
    {
      when: "the student was removed",
      act: ({ run }: ReturnType<typeof classOf>) => run(removeStep(1)),
    },
  ])("is invalid when $when", ({ act }) => {
    const room = classOf(newClass());
    room.join("old key");
    room.run(returnCodeStep(1));
    act(room);
    expect(() => room.run(returnStep(1, "new key", RETURN))).toThrow(refused("no-class"));
  });

  it("is not created for an unknown student", () => {
    const { run } = classOf(newClass());
    expect(() => run(returnCodeStep(1))).toThrow(refused("no-student"));
    expect(() => run(removeStep(1))).toThrow(refused("no-student"));
  });
});

describe("what a teacher sets", () => {
  it("ends a pause by the clock", () => {
    const { held, run } = classOf(newClass());
    run(pauseStep(60));
    expect(settingsOf(held.state.row, 20_000).pauseEndsInMs).toBe(40_000);
    expect(settingsOf(held.state.row, 60_000).pauseEndsInMs).toBeNull();
  });

  it("counts the time of all pauses, also of those that were ended or replaced", () => {
    const { held, run } = classOf(newClass());
    run(pauseStep(60));
    held.now = 10_000;
    run(pauseStep(600));
    held.now = 30_000;
    run(resumeStep());
    held.now = 50_000;
    run(resumeStep());
    run(pauseStep(10));
    expect(pausedMs(held.state.row, 55_000)).toBe(35_000);
    expect(pausedMs(held.state.row, 99_000)).toBe(40_000);
  });

  it.each([
    { what: "the lock", step: lockStep(true) },
    { what: "the pace", step: paceStep(2) },
    { what: "no pause", step: resumeStep() },
  ])("changes nothing if $what is set already", ({ step }) => {
    const { held, run } = classOf(newClass());
    run(step);
    const before = held.state.row.version;
    run(step);
    expect(held.state.row.version).toBe(before);
  });
});

describe("what a student sends", () => {
  const caller = { student: 1, key: "key" };
  const opened = { kind: "opened", lesson: "0a1b2c3d4", task: 1 } as const;

  function classWithStudent(change: Partial<ClassRow> = {}) {
    const room = classOf(newClass(change));
    room.join("key");
    room.events.splice(0);
    return room;
  }

  it("is another name, twice", () => {
    const { held, run } = classWithStudent();
    const names = [0, 1].map(() => {
      run(renameStep(caller));
      return held.state.students.get(1)?.name;
    });
    // The highest free number, which is not the present one.
    expect(names).toEqual([NAME_WORDS - 2, NAME_WORDS - 1]);
    expect(() => run(renameStep(caller))).toThrow(refused("no-other-name"));
  });

  it("is another name only if one is free", () => {
    const { run } = classWithStudent({ names: ["Ada"] });
    expect(() => run(renameStep(caller))).toThrow(refused("no-other-name"));
  });

  it("is progress, which counts once however often it is sent, with its time without pauses", () => {
    const { held, events, run } = classWithStudent();
    run(pauseStep(60));
    held.now = 100_000;
    for (const seq of [1, 1]) run(progressStep(caller, seq, opened));
    expect(held.state.students.get(1)?.progress).toBe(1);
    const progress = { seq: 1, at: "1970-01-01T00:01:40.000Z", activeMs: 40_000, event: opened };
    expect(events.slice(1)).toMatchObject([{ type: "student", progress }]);
    expect(() => run(progressStep(caller, 3, opened))).toThrow(refused("bad-request"));
  });

  it("is a program, of which the teacher sees that it is there", () => {
    const { events, run } = classWithStudent();
    run(programStep(caller, 2, "c1.AAAA"));
    expect(events).toMatchObject([{ type: "student", student: { programs: 1 }, progress: null }]);
  });

  it("is a request for help, whose first time counts until it is withdrawn", () => {
    const { held, run } = classWithStudent();
    for (const now of [1_000, 2_000]) {
      held.now = now;
      run(helpStep(caller, true));
    }
    expect(held.state.students.get(1)?.helpSince).toBe(1_000);
    run(helpStep(caller, false));
    expect(held.state.students.get(1)?.helpSince).toBeNull();
  });

  it.each([
    { what: "name", step: renameStep },
    { what: "progress", step: (each: typeof caller) => progressStep(each, 1, opened) },
    { what: "program", step: (each: typeof caller) => programStep(each, 1, "c1.AAAA") },
    { what: "help", step: (each: typeof caller) => helpStep(each, true) },
  ])("is refused with the key of an earlier device or of a removed student: $what", ({ step }) => {
    const { run } = classWithStudent();
    expect(() => run(step({ student: 1, key: "old key" }))).toThrow(refused("not-authorised"));
    run(removeStep(1));
    expect(() => run(step(caller))).toThrow(refused("not-authorised"));
  });
});

it.each([
  { what: "the lock", set: (room: Room) => room.run(lockStep(true)) },
  { what: "the pace", set: (room: Room) => room.run(paceStep(2)) },
  { what: "the code", set: (room: Room) => room.run(newCodeStep()) },
  { what: "a pause", set: (room: Room) => room.run(pauseStep(60)) },
])("dashboards see a change of $what as one numbered event", ({ set }) => {
  const room = classOf(newClass());
  set(room);
  const { held, events } = room;
  expect(events).toEqual([{ type: "settings" }]);
  expect(held.state.row.n).toBe(1);
});
