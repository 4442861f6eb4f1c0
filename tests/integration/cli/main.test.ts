/** Runs the command line with real files: in a real process, and its texts in this process. */
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { generateTree } from "@corridor/maze";
import { paperPrograms } from "@corridor/program/testing";
import { afterAll, describe, expect, it } from "vitest";
import { corridorHere } from "../../support/cli/run-here.ts";

const folder = mkdtempSync(join(tmpdir(), "corridor-cli-"));
afterAll(() => rmSync(folder, { recursive: true }));

function file(name: string, content: unknown): string {
  const path = join(folder, name);
  const isWritten = typeof content === "string" || content instanceof Uint8Array;
  writeFileSync(path, isWritten ? content : JSON.stringify(content));
  return path;
}

const main = new URL("../../../apps/cli/src/main.ts", import.meta.url).pathname;

function corridor(...args: string[]): { code: number | null; out: string; errors: string } {
  const { status, stdout, stderr } = spawnSync(process.execPath, [main, ...args], {
    encoding: "utf8",
  });
  return { code: status, out: stdout, errors: stderr };
}

const maze = file("maze.json", generateTree({ columns: 9, rows: 9, seed: 4, name: "Tree" }));
const rightWall = file("right-wall.json", paperPrograms[1]?.program);
const wrong = file("wrong.json", paperPrograms[3]?.program);

it("ends without a stack trace when nobody reads its output, as before `| head -1`", async () => {
  const child = spawn(process.execPath, [main, "--help"]);
  child.stdout.destroy();
  let errors = "";
  child.stderr.setEncoding("utf8").on("data", (text: string) => (errors += text));
  expect(await once(child, "close")).toEqual([141, null]);
  expect(errors).toBe("");
});

describe("help", () => {
  const names = ["simulate", "grade", "report", "maze", "conformance"];

  it("lists all commands", () => {
    const { code, out } = corridor("--help");
    expect(code).toBe(0);
    for (const name of names) expect(out).toMatch(new RegExp(`^  ${name} +[a-z]`, "m"));
  });

  it.each(names)("of %s describes its usage, options and exit codes", async (name) => {
    const { code, out, errors } = await corridorHere(name, "--help");
    expect({ code, errors }).toEqual({ code: 0, errors: "" });
    const [usage = "", ...rest] = out.split("\n\n");
    expect(usage).toContain(`corridor ${name} `);
    const options = rest.find((part) => part.startsWith("Options:")) ?? "";
    for (const option of usage.match(/--[a-z]+/g) ?? []) {
      expect(options).toMatch(new RegExp(`^  ${option} `, "m"));
    }
    expect(rest.at(-1)).toMatch(/^Exit codes:\n  0  .*\n(?:  1  .*\n)?  2  .*\n$/);
  });

  it.each([
    { found: "grad", answer: "Did you mean grade?" },
    { found: "Simulate", answer: "Did you mean simulate?" },
    { found: "conf", answer: "Did you mean conformance?" },
    {
      found: "drive",
      answer: "The commands are simulate, grade, report, maze, conformance, ros, mcp, mms, viple.",
    },
  ])("names the command that resembles $found", async ({ found, answer }) => {
    expect(await corridorHere(found)).toMatchObject({
      code: 2,
      out: "",
      errors: `Unknown command "${found}". ${answer} Run corridor --help to see all commands.\n`,
    });
  });
});

describe("simulate", () => {
  it("prints one line of JSON with the documented fields in their order", () => {
    const { code, out, errors } = corridor("simulate", "--maze", maze, "--program", rightWall);
    expect({ code, errors }).toEqual({ code: 0, errors: "" });
    expect(out).toMatch(
      /^\{"ticks":7200,"seconds":120,"bumps":0,"visitedCells":31,"openCells":31,"distance":[\d.]+,"goal":\{"reached":true,"tick":\d+\},"pose":\{"x":[\d.]+,"y":[\d.]+,"heading":[\d.]+\},"lines":\{"default":\d+,"0":\d+,"1":\d+\}\}\n$/,
    );
  });

  it("reads a file that starts with a byte order mark", async () => {
    const withMark = file("with-mark.json", `\uFEFF${JSON.stringify(paperPrograms[1]?.program)}`);
    const args = ["simulate", "--maze", maze, "--program"];
    const { code, out } = await corridorHere(...args, withMark);
    expect(code).toBe(0);
    expect(out).toBe((await corridorHere(...args, rightWall)).out);
  });

  it("stops at the goal with --until goal", async () => {
    const args = ["simulate", "--maze", maze, "--program", rightWall];
    const whole = JSON.parse((await corridorHere(...args)).out);
    const short = JSON.parse((await corridorHere(...args, "--until", "goal")).out);
    expect(short.ticks).toBe(whole.goal.tick);
    expect(short.goal).toEqual(whole.goal);
  });

  it("stops at the first bump with --until bump", async () => {
    const args = ["simulate", "--maze", maze, "--program", wrong, "--until", "bump"];
    expect(JSON.parse((await corridorHere(...args)).out)).toMatchObject({ bumps: 1 });
  });

  it("prints the same digest for the same inputs, and a different one for different inputs", async () => {
    const args = ["simulate", "--maze", maze, "--digest", "--seconds", "20"];
    const first = corridor(...args, "--program", rightWall);
    expect(first.code).toBe(0);
    expect((await corridorHere(...args, "--program", rightWall)).out).toBe(first.out);
    expect((await corridorHere(...args, "--program", wrong)).out).not.toBe(first.out);
    const commands = file("commands.json", [
      { tick: 0, command: { action: "drive", left: 0.31, right: 0.3 } },
      { tick: 200, command: { action: "left 90" } },
    ]);
    const commanded = await corridorHere(...args, "--commands", commands);
    expect(commanded.code).toBe(0);
    expect(commanded.out).not.toBe(first.out);
  });
});

describe("grade", () => {
  it("diagnoses failed runs with --why, and only those", () => {
    const args = ["--program", rightWall, wrong, "--maze", maze, "--why"];
    const lines = corridor("grade", ...args)
      .out.trim()
      .split("\n");
    const [good, bad] = lines.map((line): unknown => JSON.parse(line));
    expect(good).toMatchObject({ diagnosis: null });
    expect(bad).toMatchObject({ diagnosis: { event: { kind: "bump" }, fixes: expect.any(Array) } });
    expect(corridor("grade", ...args, "--csv").code).toBe(2);
  });

  it("prints one line per pair in the order of the files, then a summary", () => {
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

  it("prints the same results on all cores as on one", async () => {
    // The first run takes so long that the other cores start and get the rest.
    const mazes = [1, 2, 3, 4, 5, 6].map((seed) => {
      const tree = generateTree({ columns: 15, rows: 15, seed, name: `${seed}` });
      return file(`tree-${seed}.json`, seed === 1 ? { ...tree, goals: [] } : tree);
    });
    const limits = ["--seconds", "4000", "--until", "goal"];
    const parallel = corridor("grade", "--program", rightWall, "--maze", ...mazes, ...limits);
    const lines = parallel.out.trim().split("\n").slice(0, -1);
    expect(lines).toHaveLength(6);
    for (const line of lines) {
      const { program, maze: mazeFile, ...rest } = JSON.parse(line);
      const alone = ["simulate", "--program", program, "--maze", mazeFile, ...limits];
      expect(JSON.parse((await corridorHere(...alone)).out)).toEqual(rest);
    }
  });

  it("prints valid CSV and quotes file names that need it", () => {
    const odd = file('odd, "name".json', paperPrograms[1]?.program);
    const { out } = corridor("grade", "--csv", "--program", odd, "--maze", maze);
    const [header, row] = out.split("\n");
    expect(header).toBe(
      "program,maze,ticks,seconds,bumps,visitedCells,openCells,distance,goalReached,goalTick",
    );
    expect(row).toContain(`"${odd.replaceAll('"', '""')}"`);
  });
});

describe("maze", () => {
  const drawing = "o---o---o\n|       |\no   o---o\n|   | G |\no---o---o\n";
  const contest = file("contest.map", `${drawing.replaceAll("\n", "\r\n")}\r\nFinal\r\n`);

  it("prints the documented fields of a contest maze in their order", () => {
    expect(corridor("maze", contest)).toEqual({
      code: 0,
      out: '{"columns":2,"rows":2,"start":{"x":0,"y":0,"heading":"north"},"goals":[{"x":1,"y":0}],"solvable":false,"shortestPath":null,"wallFollower":false,"brokenRules":[{"rule":"unreachable-cells","count":1},{"rule":"goal-entrances","count":0}]}\n',
      errors: "",
    });
  });

  it("converts a maze to every format and back, also the name of a document", async () => {
    const walls = generateTree({ columns: 33, rows: 33, seed: 4, name: "tree" }).blocks;
    const goals = [15, 17].flatMap((row) => [15, 17].map((column) => ({ column, row })));
    const start = { column: 1, row: 31, heading: "north" };
    const document = {
      format: "corridor/maze",
      version: 1,
      name: "tree",
      blocks: walls,
      start,
      goals,
    };
    const original = file("tree.json", document);
    const main = new URL("../../../apps/cli/src/main.ts", import.meta.url).pathname;
    for (const format of ["json", "text", "map", "num", "maz"]) {
      const { bytes } = await corridorHere("maze", original, "--to", format);
      const written = file(`tree.${format}`, new Uint8Array(bytes));
      const { out } = await corridorHere("maze", written, "--to", "json");
      expect(JSON.parse(out)).toEqual(document);
    }
    // A process does not change the bytes of the binary format.
    const { stdout } = spawnSync(process.execPath, [main, "maze", original, "--to", "maz"]);
    expect(stdout).toEqual(readFileSync(join(folder, "tree.maz")));
  });

  it("opens contest mazes wherever a command takes mazes", async () => {
    const args = ["--program", rightWall, "--until", "goal"];
    const open = file("open.map", drawing.replace("o---o\n|   | G |", "o   o\n|   | G |"));
    const { out } = await corridorHere("simulate", "--maze", open, ...args);
    expect(JSON.parse(out)).toMatchObject({ goal: { reached: true } });
    const [line = ""] = corridor("grade", "--maze", open, ...args).out.split("\n");
    expect(JSON.parse(line)).toMatchObject({ maze: open, goal: { reached: true } });
  });

  it("ignores a description after a drawing, in any encoding", async () => {
    const described = file("latin.map", Buffer.from(`${drawing}\nS\u00E3o Paulo`, "latin1"));
    expect((await corridorHere("maze", described)).code).toBe(0);
  });
});

describe("invalid input", () => {
  const broken = file("broken.json", { ...paperPrograms[1]?.program, default: "fly" });

  it("ends the process with code 2, and prints only to standard error", () => {
    const { code, out, errors } = corridor();
    expect({ code, out }).toEqual({ code: 2, out: "" });
    expect(errors).toContain("Expected a command.\n\nUsage: corridor COMMAND");
  });

  it.each([
    { name: "no robot", args: ["conformance"], message: "address: found nothing, expected" },
    {
      name: "gateways and no robot",
      args: ["conformance", "--gateways"],
      message: "address: found nothing, expected",
    },
    {
      name: "an unknown gateway",
      args: ["conformance", "--gateways", "ros,grpc", "http://localhost/r/abc#0123456789"],
      message: "--gateways: found another text, expected a list of ros, mcp, soap",
    },
    {
      name: "an unknown option of conformance",
      args: ["conformance", "http://localhost/r/abc#0123456789", "--gateway"],
      message: "The options are --gateways, --help.",
    },
    { name: "an unknown option", args: ["simulate", "--speed", "3"], message: "--speed" },
    {
      name: "a missing file",
      args: ["simulate", "--maze", join(folder, "nowhere.json"), "--program", rightWall],
      message: "nowhere.json: document: found no file of this name, expected a readable file",
    },
    {
      name: "an unknown action",
      args: ["simulate", "--maze", maze, "--program", broken],
      message: `${broken}: default: found "fly", expected one of forward, reverse`,
    },
    {
      name: "a maze file as the program",
      args: ["simulate", "--maze", maze, "--program", maze],
      message: 'format: found "corridor/maze", expected "corridor/program"',
    },
    {
      name: "a file that is not JSON",
      args: ["simulate", "--maze", file("text.json", "hello"), "--program", rightWall],
      message: 'line 1: found "hello", expected a row of squares',
    },
    {
      name: "a maze that is cut off",
      args: ["simulate", "--maze", file("cut.json", '{"format":'), "--program", rightWall],
      message: "expected a JSON document",
    },
    {
      name: "a binary maze whose walls do not agree",
      args: ["simulate", "--maze", file("open.maz", new Uint8Array(256)), "--program", rightWall],
      message: "byte 0: found no wall in the south, expected the outer wall",
    },
    { name: "no file to check", args: ["maze"], message: "FILE: found nothing, expected one maze" },
    {
      name: "an unknown format",
      args: ["maze", maze, "--to", "bmp"],
      message: '--to: found "bmp", expected one of json, text, map, num, maz',
    },
    {
      name: "a maze that a format cannot store",
      args: ["maze", maze, "--to", "num"],
      message: "start: found column 1, row 1, south, expected the cell at the bottom left",
    },
    {
      name: "a maze without posts and walls",
      args: ["maze", file("even.txt", "S.\n..")],
      message: "blocks: found 2 x 2 cells, expected odd numbers from 3 to 255",
    },
    {
      name: "0 seconds",
      args: ["simulate", "--maze", maze, "--program", rightWall, "--seconds", "0"],
      message: '--seconds: found "0", expected a number from 1/60 (one tick)',
    },
    {
      name: "less than a tick",
      args: ["simulate", "--maze", maze, "--program", rightWall, "--seconds", "0.001"],
      message: '--seconds: found "0.001", expected a number from 1/60 (one tick)',
    },
    {
      name: "--until goal with --digest",
      args: ["simulate", "--maze", maze, "--program", rightWall, "--digest", "--until", "goal"],
      message: '--until: found "goal" with --digest, expected "time"',
    },
    {
      name: "a positional argument",
      args: ["simulate", "--maze", maze, "--program", rightWall, "again"],
      message: "The options are --maze, --program",
    },
    {
      name: "an unknown value of --until",
      args: ["grade", "--maze", maze, "--program", rightWall, "--until", "dawn"],
      message: '--until: found "dawn", expected one of time, goal, bump',
    },
    { name: "no maze", args: ["grade", "--program", rightWall], message: "--maze: found nothing" },
  ])("exits with code 2 and prints only to standard error: $name", async ({ args, message }) => {
    const { code, out, errors } = await corridorHere(...args);
    expect({ code, out }).toEqual({ code: 2, out: "" });
    expect(errors).toContain(message);
  });

  it("does not print the key of an address", async () => {
    const { errors } = await corridorHere(
      "conformance",
      "http://localhost/r/abc#0123456789",
      "more",
    );
    expect(errors).toContain("address: found 2 arguments");
    expect(errors).not.toContain("0123456789");
  });

  it("reports every problem of every file", async () => {
    const { errors } = await corridorHere("grade", "--program", broken, maze, "--maze", broken);
    expect(errors.trim().split("\n").length).toBeGreaterThan(4);
  });
});
