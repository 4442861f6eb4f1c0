import {
  helpKinds,
  lessonOf,
  parseLesson,
  toolNames,
  type LessonDocument,
  type LessonTask,
  type UnseenMazes,
} from "@corridor/challenge";
import { generateTree, mazeKinds, type MazeDocument } from "@corridor/maze";
import { arbitraryProgram } from "@corridor/program/testing";
import fc from "fast-check";
import { MAX_LINK_LENGTH } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { decodeLink, encodeLink } from "./link.ts";
import type { LinkContent } from "./link-body.ts";
import { anyList, anyText, arbitraryTask } from "./testing/arbitrary-task.ts";
import { randomMaze } from "./testing/sample-mazes.ts";

const anySide = fc.integer({ min: 2, max: 16 }).map((half) => 2 * half + 1);
const anyUnseen: fc.Arbitrary<UnseenMazes> = fc
  .record({
    kind: fc.constantFrom(...mazeKinds),
    columns: anySide,
    rows: anySide,
    seed: fc.integer({ min: 0, max: 999_999 }),
    count: fc.integer({ min: 1, max: 1_000 }),
    fails: fc.nat(999),
  })
  .map(({ fails, ...rest }) => ({ ...rest, pass: Math.max(1, rest.count - fails) }));

const anyTask: fc.Arbitrary<LessonTask> = fc
  .tuple(
    arbitraryTask(3_600),
    fc.option(anyList(toolNames)),
    fc.option(anyList(helpKinds)),
    fc.option(anyUnseen),
  )
  .map(([task, tools, help, unseen]) => ({
    ...task,
    allowed: { ...task.allowed, tools, help },
    unseen,
  }));

const anyLesson: fc.Arbitrary<LessonDocument> = fc.record({
  format: fc.constant("corridor/challenge" as const),
  version: fc.constant(2 as const),
  language: fc.constantFrom(null, "en", "pt-BR", "zh-Hans-CN"),
  name: anyText(60),
  intro: anyText(60),
  order: fc.constantFrom("any" as const, "in turn" as const),
  tasks: fc
    .array(anyTask, { minLength: 1, maxLength: 4 })
    // Tasks with the same mazes and texts are common.
    .chain((tasks) => fc.array(fc.constantFrom(...tasks), { minLength: 1, maxLength: 12 })),
  survey: fc.uniqueArray(
    fc.record({ id: fc.stringMatching(/^[a-z][a-z0-9_]{0,31}$/), question: anyText(80) }),
    { maxLength: 8, selector: ({ id }) => id },
  ),
});

/** A task with the texts that a teacher writes. */
function taskOf(mazes: readonly MazeDocument[], changes: Partial<LessonTask> = {}): LessonTask {
  return {
    name: "Reach the goal in every maze",
    words: {
      task: "Write a program that reaches the goal. Use 3 lines or fewer, and do not bump.",
      short: "Reach the goal in 3 lines or fewer",
      hints: ["Keep a hand on the right wall.", "A side opening needs a delayed turn."],
    },
    mazes: [...mazes],
    program: null,
    goal: { kind: "reach" },
    allowed: {
      drivers: ["program"],
      lines: 3,
      conditions: null,
      actions: null,
      edits: ["condition", "number", "action", "otherwise", "order", "lines"],
      maze: false,
      tools: ["measure", "timeline", "speed", "files"],
      help: ["truth", "hints"],
    },
    checks: { bumps: 0, seconds: 600 },
    par: { lines: 2, seconds: 90 },
    unseen: { kind: "tree", columns: 11, rows: 11, seed: 7, count: 50, pass: 45 },
    ...changes,
  };
}

function lessonWith(tasks: readonly LessonTask[]): LessonDocument {
  return {
    format: "corridor/challenge",
    version: 2,
    language: "en",
    name: "Every maze",
    intro: "",
    order: "in turn",
    tasks: [...tasks],
    survey: [],
  };
}

function mazesOf(count: number, side: number): MazeDocument[] {
  return Array.from({ length: count }, (_, at) => ({
    ...generateTree({ columns: side, rows: side, seed: at + 1, name: `Maze ${at + 1}` }),
    goals: [{ column: side - 2, row: side - 2 }],
  }));
}

/** Encodes a lesson and checks that the link decodes to an equal one. */
function lengthOf(lesson: LessonDocument): number {
  expect(parseLesson(lesson)).toEqual({ ok: true, value: lesson });
  const link = encodeLink({ lesson });
  if (!link.ok) throw new Error(link.code);
  expect(decodeLink(link.text)).toEqual({ ok: true, value: { lesson } });
  return link.text.length;
}

// cspell:ignore Напиши программу которая доходит цели Используй больше трёх строк
describe("the link of a lesson", () => {
  it("decodes to equal documents, with or without a program, or is refused as too big", () => {
    let fitting = 0;
    fc.assert(
      fc.property(anyLesson, fc.option(arbitraryProgram), (lesson, program) => {
        const content: LinkContent = program === null ? { lesson } : { lesson, program };
        const link = encodeLink(content);
        if (link.ok) fitting += 1;
        expect(link).toMatchObject(link.ok ? {} : { code: "too-big" });
        expect(link.ok ? decodeLink(link.text) : null).toEqual(
          link.ok ? { ok: true, value: content } : null,
        );
      }),
      { numRuns: 150 },
    );
    expect(fitting).toBeGreaterThan(20);
  });

  it.each([
    { mazes: 1, side: 11, max: 200 },
    { mazes: 10, side: 11, max: 280 },
    { mazes: 10, side: 33, max: 790 },
  ])(
    "has at most $max characters for $mazes mazes of $side x $side with texts",
    ({ mazes, side, max }) => {
      expect(lengthOf(lessonWith([taskOf(mazesOf(mazes, side))]))).toBeLessThanOrEqual(max);
    },
  );

  it("needs about 25 characters for a task with the ten mazes and the texts of another one", () => {
    const task = taskOf(mazesOf(10, 11));
    const one = lengthOf(lessonWith([task]));
    const twelve = lengthOf(lessonWith(Array.from({ length: 12 }, () => task)));
    expect(twelve - one).toBeLessThanOrEqual(11 * 25);
  });

  it("needs about one character for each letter of a text in another script", () => {
    const words = { task: "", short: "", hints: [] };
    const task =
      "Напиши программу, которая доходит до цели. Используй не больше трёх строк. ".repeat(3);
    const empty = lengthOf(lessonWith([taskOf(mazesOf(1, 11), { words })]));
    const full = lengthOf(lessonWith([taskOf(mazesOf(1, 11), { words: { ...words, task } })]));
    expect(full - empty).toBeLessThanOrEqual(task.length * 1.2);
  });

  it("is the link of a challenge if version 1 can hold the lesson", () => {
    const [task] = lessonOf({
      format: "corridor/challenge",
      version: 1,
      ...taskOf(mazesOf(1, 11)),
      allowed: { ...taskOf([]).allowed },
    }).tasks;
    if (task === undefined) throw new Error("no task");
    const plain = { ...lessonWith([task]), language: null, name: "", order: "any" as const };
    expect(lengthOf(plain)).toBeGreaterThan(0);
    expect(encodeLink({ lesson: plain })).not.toEqual(encodeLink({ lesson: lessonWith([task]) }));
  });
});

describe("a lesson that is too big for a link", () => {
  const texts = {
    task: noise(400),
    short: noise(120),
    hints: Array(6).fill(noise(400)) as string[],
  };

  it.each<[string, readonly LessonTask[], string, LinkPartOf]>([
    [
      "random mazes",
      [taskOf(mazesOf(1, 11)), taskOf(Array.from({ length: 10 }, (_, at) => noisyMaze(at)))],
      "shorten the mazes of task 2",
      { task: 1, part: "mazes" },
    ],
    [
      "long texts",
      Array.from({ length: 12 }, (_, at) =>
        taskOf(mazesOf(1, 11), {
          words: { ...texts, hints: Array.from({ length: at === 4 ? 6 : 3 }, () => noise(400)) },
        }),
      ),
      "shorten the texts of task 5",
      { task: 4, part: "texts" },
    ],
  ])("is refused with its size and the part to shorten: %s", (_, tasks, remedy, longest) => {
    const link = encodeLink({ lesson: lessonWith(tasks) });
    expect(link).toMatchObject({ ok: false, code: "too-big", longest });
    const [problem] = link.ok ? [] : link.problems;
    expect(problem?.found).toMatch(/^\d{4,6} characters$/);
    expect(link).toMatchObject({ length: Number.parseInt(problem?.found ?? "", 10) });
    expect(problem?.expected).toContain(`at most ${MAX_LINK_LENGTH} characters: ${remedy}`);
  });

  it("is refused if its mazes exceed the size of a file, however few characters they need", () => {
    const open: MazeDocument = {
      ...randomMaze("", 256, 0, false, 1),
      goals: [{ column: 255, row: 255 }],
    };
    const tasks = (count: number) =>
      Array.from({ length: count }, () => taskOf(Array(10).fill(open)));
    expect(lengthOf(lessonWith(tasks(3)))).toBeLessThan(MAX_LINK_LENGTH / 8);
    expect(encodeLink({ lesson: lessonWith(tasks(4)) })).toMatchObject({
      ok: false,
      code: "too-big",
      length: null,
      problems: [{ found: "more than a link can contain" }],
    });
  });
});

type LinkPartOf = { task: number; part: string };

let seed = 1;
function noise(length: number): string {
  return Array.from({ length }, () => {
    seed = (seed * 48_271) % 2_147_483_647;
    return String.fromCharCode(33 + (seed % 90));
  }).join("");
}

function noisyMaze(at: number): MazeDocument {
  const maze = randomMaze(`Noise ${at}`, 101, 50, false, at + 1);
  return { ...maze, goals: [{ column: maze.start.column, row: maze.start.row }] };
}
