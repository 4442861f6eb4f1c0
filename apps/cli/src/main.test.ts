/** The command line as a teacher calls it: a real process, real files. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { generateTree } from "@corridor/maze";
import { paperPrograms } from "@corridor/program/testing";
import { afterAll, describe, expect, it } from "vitest";

const folder = mkdtempSync(join(tmpdir(), "corridor-cli-"));
afterAll(() => rmSync(folder, { recursive: true }));

function file(name: string, content: unknown): string {
  const path = join(folder, name);
  writeFileSync(path, typeof content === "string" ? content : JSON.stringify(content));
  return path;
}

function corridor(...words: string[]): { code: number | null; out: string; errors: string } {
  const main = new URL("./main.ts", import.meta.url).pathname;
  const { status, stdout, stderr } = spawnSync(process.execPath, [main, ...words], {
    encoding: "utf8",
  });
  return { code: status, out: stdout, errors: stderr };
}

const maze = file("maze.json", generateTree({ columns: 9, rows: 9, seed: 4, name: "Tree" }));
const rightWall = file("right-wall.json", paperPrograms[1]?.program);
const wrong = file("wrong.json", paperPrograms[3]?.program);

describe("simulate", () => {
  it("prints one line of JSON with the fields of the contract in their order", () => {
    const { code, out, errors } = corridor("simulate", "--maze", maze, "--program", rightWall);
    expect({ code, errors }).toEqual({ code: 0, errors: "" });
    expect(out).toMatch(
      /^\{"ticks":7200,"seconds":120,"bumps":0,"visitedCells":31,"openCells":31,"distance":[\d.]+,"goal":\{"reached":true,"tick":\d+\},"pose":\{"x":[\d.]+,"y":[\d.]+,"heading":[\d.]+\},"lines":\{"default":\d+,"0":\d+,"1":\d+\}\}\n$/,
    );
  });

  it("reads a file with the mark that some editors put first", () => {
    const marked = file("marked.json", `\uFEFF${JSON.stringify(paperPrograms[1]?.program)}`);
    const { out } = corridor("simulate", "--maze", maze, "--program", marked);
    expect(out).toBe(corridor("simulate", "--maze", maze, "--program", rightWall).out);
  });

  it("stops at the goal when asked to", () => {
    const whole = JSON.parse(corridor("simulate", "--maze", maze, "--program", rightWall).out);
    const words = ["--maze", maze, "--program", rightWall, "--until", "goal"];
    const short = JSON.parse(corridor("simulate", ...words).out);
    expect(short.ticks).toBe(whole.goal.tick);
    expect(short.goal).toEqual(whole.goal);
  });

  it("stops at the first bump when asked to", () => {
    const words = ["--maze", maze, "--program", wrong, "--until", "bump"];
    expect(JSON.parse(corridor("simulate", ...words).out)).toMatchObject({ bumps: 1 });
  });

  it("gives the same digest for the same inputs, and another for others", () => {
    const words = ["simulate", "--maze", maze, "--digest", "--seconds", "20"];
    const first = corridor(...words, "--program", rightWall);
    expect(first.code).toBe(0);
    expect(corridor(...words, "--program", rightWall).out).toBe(first.out);
    expect(corridor(...words, "--program", wrong).out).not.toBe(first.out);
    const commands = file("commands.json", [
      { tick: 0, command: { action: "drive", left: 0.31, right: 0.3 } },
      { tick: 200, command: { action: "left 90" } },
    ]);
    const driven = corridor(...words, "--commands", commands);
    expect(driven.code).toBe(0);
    expect(driven.out).not.toBe(first.out);
  });
});

describe("grade", () => {
  it("says with --why what caused a failure, and nothing of a run that did not fail", () => {
    const words = ["--program", rightWall, wrong, "--maze", maze, "--why"];
    const lines = corridor("grade", ...words)
      .out.trim()
      .split("\n");
    const [good, bad] = lines.map((line): unknown => JSON.parse(line));
    expect(good).toMatchObject({ diagnosis: null });
    expect(bad).toMatchObject({ diagnosis: { event: { kind: "bump" }, fixes: expect.any(Array) } });
    expect(corridor("grade", ...words, "--csv").code).toBe(2);
  });

  it("prints a line a pair in the order of the files, then a summary", () => {
    const { code, out } = corridor("grade", "--program", rightWall, wrong, "--maze", maze);
    const lines = out
      .trim()
      .split("\n")
      .map((line) => JSON.parse(line));
    expect(code).toBe(0);
    expect(lines.slice(0, 2)).toMatchObject([
      { program: rightWall, maze, ticks: 18_000, bumps: 0 },
      { program: wrong, maze, bumps: 1 },
    ]);
    expect(lines[2]).toEqual({
      summary: { runs: 2, goalReached: 1, withoutBumps: 1, allCellsVisited: 1 },
    });
  });

  it("gives on all cores what it gives on one", () => {
    const mazes = [1, 2, 3].map((seed) =>
      file(`tree-${seed}.json`, generateTree({ columns: 15, rows: 15, seed, name: `${seed}` })),
    );
    const words = ["--program", rightWall, wrong, "--maze", ...mazes];
    const many = corridor("grade", ...words, "--seconds", "4000");
    const lines = many.out.trim().split("\n").slice(0, -1);
    expect(lines).toHaveLength(6);
    for (const line of lines) {
      const { program, maze: mazeFile, ...rest } = JSON.parse(line);
      const alone = ["--program", program, "--maze", mazeFile, "--seconds", "4000"];
      expect(JSON.parse(corridor("simulate", ...alone).out)).toEqual(rest);
    }
  });

  it("prints a table that spreadsheets read, with names quoted where they need it", () => {
    const odd = file('odd, "name".json', paperPrograms[1]?.program);
    const { out } = corridor("grade", "--csv", "--program", odd, "--maze", maze);
    const [head, row] = out.split("\n");
    expect(head).toBe(
      "program,maze,ticks,seconds,bumps,visitedCells,openCells,distance,goalReached,goalTick",
    );
    expect(row).toContain(`"${odd.replaceAll('"', '""')}"`);
  });
});

describe("bad input", () => {
  const broken = file("broken.json", { ...paperPrograms[1]?.program, default: "fly" });
  it.each([
    { name: "no command", words: [], says: "command: found" },
    { name: "an unknown option", words: ["simulate", "--speed", "3"], says: "--speed" },
    {
      name: "a missing file",
      words: ["simulate", "--maze", join(folder, "nowhere.json"), "--program", rightWall],
      says: "nowhere.json: document: found no file of this name, expected a file",
    },
    {
      name: "an unknown action",
      words: ["simulate", "--maze", maze, "--program", broken],
      says: `${broken}: default: found "fly", expected one of forward, reverse`,
    },
    {
      name: "a maze where a program belongs",
      words: ["simulate", "--maze", maze, "--program", maze],
      says: 'format: found "corridor/maze", expected "corridor/program"',
    },
    {
      name: "no JSON",
      words: ["simulate", "--maze", file("text.json", "hello"), "--program", rightWall],
      says: "expected a JSON document",
    },
    {
      name: "a time of 0",
      words: ["simulate", "--maze", maze, "--program", rightWall, "--seconds", "0"],
      says: '--seconds: found "0", expected a number from 1/60 (one tick)',
    },
    {
      name: "less than a tick",
      words: ["simulate", "--maze", maze, "--program", rightWall, "--seconds", "0.001"],
      says: '--seconds: found "0.001", expected a number from 1/60 (one tick)',
    },
    {
      name: "an end that a digest does not have",
      words: ["simulate", "--maze", maze, "--program", rightWall, "--digest", "--until", "goal"],
      says: '--until: found "goal" beside --digest, expected "time"',
    },
    {
      name: "a word too many",
      words: ["simulate", "--maze", maze, "--program", rightWall, "again"],
      says: "Expected only --maze, --program",
    },
    {
      name: "an unknown end",
      words: ["grade", "--maze", maze, "--program", rightWall, "--until", "dawn"],
      says: '--until: found "dawn", expected one of time, goal, bump',
    },
    { name: "no maze", words: ["grade", "--program", rightWall], says: "--maze: found nothing" },
  ])("$name: exit 2, a line on standard error, nothing on standard output", ({ words, says }) => {
    const { code, out, errors } = corridor(...words);
    expect({ code, out }).toEqual({ code: 2, out: "" });
    expect(errors).toContain(says);
  });

  it("names every problem of every file", () => {
    const { errors } = corridor("grade", "--program", broken, maze, "--maze", broken);
    expect(errors.trim().split("\n").length).toBeGreaterThan(4);
  });
});
