import { lessonMark } from "@corridor/challenge";
import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import { mazePresets } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { Recording, type RunInput } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { handInsOf, readHandInFile } from "./hand-in.ts";
import { readLessonLink } from "./link-address.ts";
import type { LinkContent } from "./link-body.ts";
import { encodeLink } from "./link.ts";

const [preset] = mazePresets;
const found = programPresets.find(({ id }) => id === "right-wall");
if (preset === undefined || found === undefined) throw new Error("a preset is gone");
const { maze } = preset;
const { program } = found;

const task = taskIn([maze], { name: "One maze", allowed: { edits: ["lines"] } });
const lesson = lessonOfTasks("Two tasks", [task, { ...task, name: "Again" }]);

function linkOf(content: LinkContent): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

const text = linkOf({ program });

describe("hand-ins", () => {
  it.each([
    ["the text of a link", text],
    ["a complete address", `https://corridor.example/#${text}`],
    ["a link with a maze", linkOf({ program, maze })],
    ["a link with a lesson", linkOf({ program, lesson })],
    ["a line of a Windows file", `${text}\r`],
  ])("contain a program: %s", (_, line) => {
    expect(handInsOf(line, lesson)).toMatchObject({
      ok: true,
      value: [{ line: 1, read: { ok: true, value: { attempt: program, task: null } } }],
    });
  });

  it.each([
    ["a cut link", text.slice(0, -3), "a complete link: copy it again"],
    ["a short link", "https://corridor.example/m/bcdf", "a short link is not fetched"],
    ["a link of a lesson", linkOf({ lesson }), "a program or a completion code"],
    ["a name", "Anna", "one that begins with 1"],
  ])("are unreadable without a program: %s", (_, line, expected) => {
    const read = handInsOf(line, lesson);
    expect(read).toMatchObject({ ok: true, value: [{ read: { ok: false } }] });
    expect(JSON.stringify(read)).toContain(expected);
  });

  it.each([
    ["a program", { ...program, name: "" }],
    ["a manual drive", [{ tick: 3, command: { action: "forward" as const } }]],
  ])("are a completion code of one task, with %s", (_, attempt) => {
    const code = linkOf({ completion: { lesson: lessonMark(lesson), task: 1, attempt } });
    for (const line of [code, `https://corridor.example/#${code}`]) {
      const value = [{ line: 1, read: { ok: true, value: { attempt, task: 1 } } }];
      expect(handInsOf(line, lesson)).toEqual({ ok: true, value });
    }
  });

  it.each([
    [
      "another lesson",
      { lesson: lessonMark({ ...lesson, name: "Other" }), task: 0 },
      "other-lesson",
      "Not checked: this code belongs to another lesson",
    ],
    [
      "a task that the lesson does not have",
      { lesson: lessonMark(lesson), task: 2 },
      "no-task",
      "Not checked: this code belongs to task 3, the lesson has 2",
    ],
  ])("are not checked if a code belongs to %s", (_, place, code, problem) => {
    const text = linkOf({ completion: { ...place, attempt: program } });
    expect(handInsOf(text, lesson)).toMatchObject({
      ok: true,
      value: [{ line: 1, read: { ok: false, code, problem } }],
    });
  });

  it("name the lesson of a code by its mark", () => {
    const mark = lessonMark({ ...lesson, name: "Other" });
    const code = linkOf({ completion: { lesson: mark, task: 0, attempt: program } });
    const problems = [{ path: "lesson", found: mark, expected: lessonMark(lesson) }];
    expect(handInsOf(code, lesson)).toMatchObject({ value: [{ read: { problems } }] });
  });

  it("have the number of their line, and blank lines are ignored", () => {
    const read = handInsOf(`\n  \n${text}\nx\n\n${text}\n`, lesson);
    const lines = read.ok ? read.value.map(({ line }) => line) : [];
    expect(lines).toEqual([3, 4, 6]);
  });

  it("are at most 10,000", () => {
    expect(handInsOf("x\n".repeat(10_000), lesson)).toMatchObject({ ok: true });
    expect(handInsOf("x\n".repeat(10_001), lesson)).toMatchObject({
      ok: false,
      problems: [{ found: "10001 lines", expected: "at most 10000 lines" }],
    });
  });
});

/** A run of some ticks. @param inputs by tick, with the number of ticks until the next one */
function runOf(inputs: readonly [RunInput, ticks: number][]): string {
  const recording = new Recording(maze, program);
  for (const [input, ticks] of inputs) {
    if (!recording.addInput(input)) throw new Error("the input is not possible");
    for (let tick = 0; tick < ticks; tick++) recording.step();
  }
  const written = recording.toDocument("Run");
  if (!written.ok) throw new Error(written.reason);
  return written.text;
}

const me: RunInput = { do: "driver", driver: "me" };
const forward: RunInput = { do: "command", command: { action: "forward" } };
const other: ProgramDocument = { ...program, name: "Other", rules: [] };

describe("a file that is handed in", () => {
  it("contains a program", () => {
    const read = readHandInFile(`\uFEFF${JSON.stringify(program, null, 2)}`);
    expect(read).toEqual({ ok: true, value: { attempt: program, task: null } });
  });

  it("contains a run, whose newest program is checked", () => {
    const edited = runOf([
      [me, 5],
      [{ do: "driver", driver: "program" }, 5],
      [{ do: "program", program: other }, 5],
    ]);
    expect(readHandInFile(edited)).toEqual({ ok: true, value: { attempt: other, task: null } });
  });

  it("contains a run by hand, whose commands are checked", () => {
    const byHand = runOf([
      [me, 0],
      [forward, 10],
      [{ do: "cancel" }, 3],
    ]);
    expect(readHandInFile(byHand)).toEqual({
      ok: true,
      value: {
        attempt: [
          { tick: 0, command: { action: "stop" } },
          { tick: 0, command: { action: "forward" } },
          { tick: 10, command: { action: "stop" } },
        ],
        task: null,
      },
    });
  });

  it("contains a run by a script, which may end by hand", () => {
    const run = runOf([
      [{ do: "driver", driver: "remote" }, 0],
      [forward, 10],
      [me, 5],
    ]);
    expect(readHandInFile(run)).toMatchObject({
      value: { attempt: [{ tick: 0 }, { tick: 0, command: { action: "forward" } }, { tick: 10 }] },
    });
  });

  it.each(["me", "remote"] as const)("is refused if a program drove before %s", (driver) => {
    const run = runOf([
      [{ do: "program", program: other }, 5],
      [{ do: "driver", driver }, 5],
    ]);
    expect(readHandInFile(run)).toMatchObject({ ok: false, code: "run" });
  });

  it.each([
    ["a maze", JSON.stringify(maze), "format"],
    ["no JSON", "Anna", ""],
    ["a broken program", JSON.stringify({ ...program, default: "fly" }), "default"],
  ])("is unreadable if it contains %s", (_, content, path) => {
    const read = readHandInFile(content);
    expect(read).toMatchObject({ ok: false, code: "document" });
    expect(read.ok ? [] : read.problems.map((each) => each.path)).toContain(path);
  });
});

describe("the link of a lesson", () => {
  it("contains the lesson", () => {
    const read = readLessonLink(`https://corridor.example/#${linkOf({ lesson })}`);
    expect(read).toEqual({ ok: true, value: lesson });
  });

  it("is refused without a lesson", () => {
    expect(readLessonLink(text)).toMatchObject({ ok: false, problems: [{ path: "link" }] });
  });
});
