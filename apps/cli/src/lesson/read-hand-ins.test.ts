import { lessonMark, lessonOf } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { describe, expect, it } from "vitest";
import { handInsOf } from "./read-hand-ins.ts";
import { programOf, sampleChallenge, sampleTask } from "./testing/sample-task.ts";

const program = programOf("right-wall");
const lesson = { ...lessonOf(sampleChallenge), tasks: [sampleTask, sampleTask] };
function linkOf(content: Parameters<typeof encodeLink>[0]): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(link.code);
  return link.text;
}
const text = linkOf({ program });

describe("hand-ins", () => {
  it.each([
    ["the text of a link", text],
    ["a complete address", `https://corridor.example/#${text}`],
    ["a link with a maze", linkOf({ program, maze: sampleChallenge.mazes[0] ?? fail() })],
    ["a link with a challenge", linkOf({ program, lesson: lessonOf(sampleChallenge) })],
    ["a line of a Windows file", `${text}\r`],
  ])("contain a program: %s", (_, line) => {
    expect(handInsOf(line, lesson)).toMatchObject({
      ok: true,
      value: [{ name: "line 1", read: { ok: true, attempt: program, task: null } }],
    });
  });

  it.each([
    ["a program", { ...program, name: "" }],
    ["a manual drive", [{ tick: 3, command: { action: "forward" as const } }]],
  ])("are a completion code of one task, with %s", (_, attempt) => {
    const code = linkOf({ completion: { lesson: lessonMark(lesson), task: 1, attempt } });
    for (const line of [code, `https://corridor.example/#${code}`]) {
      const value = [{ name: "line 1", read: { ok: true, attempt, task: 1 } }];
      expect(handInsOf(line, lesson)).toEqual({ ok: true, value });
    }
  });

  it.each([
    [
      "another lesson",
      { lesson: lessonMark({ ...lesson, name: "Other" }), task: 0 },
      "Not checked: this code belongs to another lesson",
    ],
    [
      "a task that the lesson does not have",
      { lesson: lessonMark(lesson), task: 2 },
      "Not checked: this code belongs to task 3, the lesson has 2",
    ],
  ])("are not checked if a code belongs to %s", (_, place, problem) => {
    const code = linkOf({ completion: { ...place, attempt: program } });
    expect(handInsOf(code, lesson)).toEqual({
      ok: true,
      value: [{ name: "line 1", read: { ok: false, problem } }],
    });
  });

  it.each([
    ["a cut link", text.slice(0, -3), "a complete link: copy it again"],
    ["a short link", "https://corridor.example/m/bcdf", "a short link is not fetched"],
    [
      "a link of a challenge",
      linkOf({ lesson: lessonOf(sampleChallenge) }),
      "expected a program or a completion code",
    ],
    ["a name", "Anna", "one that begins with 1"],
  ])("are unreadable without a program: %s", (_, line, expected) => {
    const read = handInsOf(line, lesson);
    expect(read).toMatchObject({ ok: true, value: [{ read: { ok: false } }] });
    expect(JSON.stringify(read)).toContain(expected);
  });

  it("are named by their line, and blank lines are ignored", () => {
    const read = handInsOf(`\n  \n${text}\nx\n\n${text}\n`, lesson);
    const names = read.ok ? read.value.map(({ name }) => name) : [];
    expect(names).toEqual(["line 3", "line 4", "line 6"]);
  });

  it("are at most 10,000", () => {
    expect(handInsOf("x\n".repeat(10_000), lesson)).toMatchObject({ ok: true });
    expect(handInsOf("x\n".repeat(10_001), lesson)).toMatchObject({
      ok: false,
      problems: [{ found: "10001 lines", expected: "at most 10000 lines" }],
    });
  });
});

function fail(): never {
  throw new Error("no maze");
}
