/** Grades hand-ins of a lesson in a real process with real files. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { lessonMark, lessonOf } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { Recording } from "@corridor/recording";
import { afterAll, describe, expect, it } from "vitest";
import {
  programOf,
  sampleChallenge,
  sampleTask,
  tooLong,
} from "../../../apps/cli/src/lesson/testing/sample-task.ts";

const folder = mkdtempSync(join(tmpdir(), "corridor-lesson-"));
afterAll(() => rmSync(folder, { recursive: true }));

function file(name: string, content: unknown): string {
  writeFileSync(
    join(folder, name),
    typeof content === "string" ? content : JSON.stringify(content),
  );
  return name;
}

function linkOf(content: Parameters<typeof encodeLink>[0]): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

function grade(args: readonly string[], input = "") {
  const main = new URL("../../../apps/cli/src/main.ts", import.meta.url).pathname;
  const { status, stdout, stderr } = spawnSync(process.execPath, [main, "grade", ...args], {
    cwd: folder,
    encoding: "utf8",
    input,
  });
  const lines = stdout.split("\n").filter((line) => line !== "");
  return { code: status, lines, errors: stderr };
}

function rowsOf(args: readonly string[], input = "") {
  const { code, lines, errors } = grade(args, input);
  expect({ code, errors }).toEqual({ code: 0, errors: "" });
  return lines.map((line): unknown => JSON.parse(line));
}

const rightWall = file("right-wall.json", programOf("right-wall"));
const leftWall = file("left-wall.json", programOf("left-wall"));
const long = file("long.json", tooLong);
const lesson = file("lesson.json", {
  ...lessonOf(sampleChallenge),
  name: "Two tasks",
  tasks: [sampleTask, { ...sampleTask, mazes: sampleTask.mazes.slice(0, 1), unseen: null }],
});
const challenge = file("challenge.json", sampleChallenge);
const handIns = file(
  "hand-ins.txt",
  `https://corridor.example/#${linkOf({ program: programOf("right-wall") })}\r\n\r\nAnna\r\n`,
);

describe("grade --challenge", () => {
  it("prints a line for each program and task: the files, then the hand-ins, then a summary", () => {
    const files = ["--program", rightWall, leftWall, long];
    expect(rowsOf(["--challenge", lesson, ...files, "--handins", handIns])).toMatchObject([
      { program: rightWall, task: 1, passed: true, code: null, seconds: 13.367 },
      { program: rightWall, task: 2, passed: true, code: null, unseen: null },
      { program: leftWall, task: 1, passed: false, code: "bump", maze: "maze 2" },
      { program: leftWall, task: 2, passed: true, code: null },
      { program: long, task: 1, passed: false, code: "too-many-lines", maze: null, lines: 4 },
      { program: long, task: 2, passed: false, code: "too-many-lines" },
      { program: "line 1", task: 1, passed: true, unseen: { count: 5, passed: 5, failed: [] } },
      { program: "line 1", task: 2, passed: true },
      { program: "line 3", task: null, passed: false, code: "unreadable" },
      { summary: { lines: 9, passed: 5, unreadable: 1 } },
    ]);
  });

  it("checks the program of a run file", () => {
    const [maze] = sampleChallenge.mazes;
    if (maze === undefined) throw new Error("no maze");
    const recording = new Recording(maze, programOf("right-wall"));
    for (let tick = 0; tick < 60; tick++) recording.step();
    const written = recording.toDocument("Run");
    if (!written.ok) throw new Error(written.reason);
    const run = file("run.json", written.text);
    const [fromRun] = rowsOf(["--challenge", challenge, "--program", run]);
    const [fromProgram] = rowsOf(["--challenge", challenge, "--program", rightWall]);
    expect(fromRun).toEqual({ ...(fromProgram as object), program: run });
  });

  it("reads a challenge of version 1 from a file, a link, and the text of a link", () => {
    const link = linkOf({ lesson: lessonOf(sampleChallenge) });
    const fromFile = rowsOf(["--challenge", challenge, "--program", leftWall]);
    expect(fromFile).toHaveLength(2);
    for (const source of [`https://corridor.example/#${link}`, link]) {
      expect(rowsOf(["--challenge", source, "--program", leftWall])).toEqual(fromFile);
    }
  });

  it("checks a completion code in its task, and no code of another lesson", () => {
    const tasks = [sampleTask, sampleTask];
    const mine = { ...lessonOf(sampleChallenge), tasks };
    const codeOf = (mark: string) =>
      linkOf({ completion: { lesson: mark, task: 1, attempt: programOf("right-wall") } });
    const lines = [codeOf(lessonMark(mine)), codeOf(lessonMark({ ...mine, name: "Other" }))];
    const source = linkOf({ lesson: mine });
    expect(rowsOf(["--challenge", source, "--handins", "-"], lines.join("\n"))).toMatchObject([
      { program: "line 1", task: 2, passed: true, lines: 2 },
      {
        program: "line 2",
        task: null,
        passed: false,
        code: "unreadable",
        problem: "Not checked: this code belongs to another lesson",
      },
      { summary: { lines: 2, passed: 1, unreadable: 1 } },
    ]);
  });

  it("reads hand-ins from standard input", () => {
    const text = readFileSync(join(folder, handIns), "utf8");
    const args = ["--challenge", lesson, "--handins"];
    expect(rowsOf([...args, "-"], text)).toEqual(rowsOf([...args, handIns]));
  });

  it("prints the same on all cores as on one thread", () => {
    const unseen = (count: number) => ["--unseen", `loops:7x7:${count}:7`];
    const args = ["--challenge", lesson, "--program", rightWall, leftWall, long];
    const [few, many] = [3, 400].map((count) => rowsOf([...args, ...unseen(count)]));
    const failures = (rows: unknown[] | undefined) =>
      rows?.map((row) => {
        const { unseen: found } = row as { unseen?: { failed: number[] } | null };
        return found?.failed.filter((number) => number <= 3);
      });
    expect(failures(many)).toEqual(failures(few));
    expect(many?.[2]).toMatchObject({ unseen: { count: 400 } });
  });

  it("replaces the unseen mazes of every task, and requires all of them", () => {
    const args = ["--challenge", lesson, "--program", leftWall, "--unseen", "loops:7x7:5:7"];
    expect(rowsOf(args)[1]).toMatchObject({
      task: 2,
      passed: false,
      code: "bump",
      maze: "loops 4 of seed 7",
      unseen: { count: 5, passed: 4, failed: [4] },
    });
  });

  it("prints a CSV table whose fields are never formulas", () => {
    const formula = file("=1+1.json", programOf("right-wall"));
    const args = ["--challenge", lesson, "--program", formula, "--handins", handIns, "--csv"];
    expect(grade(args).lines).toEqual([
      "program,task,passed,code,maze,tick,lines,seconds,unseenCount,unseenPassed,unseenFailed,problem",
      `"'=1+1.json",1,true,,,,2,13.367,5,5,,`,
      `"'=1+1.json",2,true,,,,2,7.967,,,,`,
      "line 1,1,true,,,,2,13.367,5,5,,",
      "line 1,2,true,,,,2,7.967,,,,",
      expect.stringMatching(/^line 3,,false,unreadable,,,,,,,,"?link: found /),
    ]);
  });

  it("writes a JUnit report beside the lines", () => {
    const args = ["--challenge", lesson, "--program", rightWall, leftWall];
    expect(rowsOf([...args, "--junit", "report.xml"])).toEqual(rowsOf(args));
    const report = readFileSync(join(folder, "report.xml"), "utf8");
    expect(report).toContain('tests="4" failures="1"');
    expect(report).toContain('<testcase classname="left-wall.json" name="task 1"><failure type=');
  });

  it.each([
    { require: "all", code: 1 },
    { require: "76%", code: 1 },
    { require: "75%", code: 0 },
  ])("exits with code $code if 3 of 4 lines pass and $require must", ({ require, code }) => {
    const args = ["--challenge", lesson, "--program", rightWall, leftWall, "--require", require];
    const graded = grade(args);
    expect(graded).toMatchObject({ code, errors: "" });
    expect(graded.lines).toHaveLength(5);
  });

  it.each([
    {
      name: "a missing lesson",
      args: ["--challenge", "nowhere.json", "--program", rightWall],
      message: "nowhere.json: document: found no file of this name, expected a readable file",
    },
    {
      name: "a short link as the lesson",
      args: ["--challenge", "https://corridor.example/m/abc", "--program", rightWall],
      message: "with the text after #: a short link is not fetched",
    },
    {
      name: "a program as the lesson",
      args: ["--challenge", rightWall, "--program", rightWall],
      message: 'format: found "corridor/program", expected "corridor/challenge"',
    },
    {
      name: "a link without a lesson",
      args: ["--challenge", linkOf({ program: programOf("right-wall") }), "--program", rightWall],
      message: "--challenge: link: found a link without a lesson, expected",
    },
    {
      name: "a lesson as the program",
      args: ["--challenge", lesson, "--program", lesson],
      message: 'lesson.json: format: found "corridor/challenge", expected "corridor/program"',
    },
    {
      name: "no hand-in",
      args: ["--challenge", lesson, "--handins", "-"],
      message: "--handins: found no lines, expected links or completion codes",
    },
    {
      name: "a report in a missing folder",
      args: ["--challenge", lesson, "--program", rightWall, "--junit", "nowhere/report.xml"],
      message: "nowhere/report.xml: found no file of this name, expected a writable file",
    },
    {
      name: "--maze",
      args: ["--challenge", lesson, "--program", rightWall, "--maze", lesson],
      message: "--maze: found with --challenge, expected without --challenge",
    },
  ])("exits with code 2 and prints only to standard error: $name", ({ args, message }) => {
    const { code, lines, errors } = grade(args);
    expect({ code, lines }).toEqual({ code: 2, lines: [] });
    expect(errors).toContain(message);
  });

  it("rejects more than 16 MiB of hand-ins", () => {
    const { code, errors } = grade(["--challenge", lesson, "--handins", "-"], "x".repeat(17 << 20));
    expect(code).toBe(2);
    expect(errors).toContain("standard input: found more, expected at most 16777216 bytes");
  });
});
