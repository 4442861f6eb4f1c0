import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, describe, expect, it } from "vitest";
import {
  documentOf,
  gridOfDrawing,
  mouseMazes,
} from "../../../../packages/mouse/src/testing/mouse-mazes.ts";
import { ManualTimers } from "@corridor/protocol/testing";
import { SimulatedPort } from "../../../../packages/mouse/src/testing/simulated-port.ts";
import { MouseSession } from "../../../../packages/mouse/src/mouse-session.ts";
import { inPath } from "../../../../scripts/programs.ts";
import { compilerOptions, shortRunOptions } from "../../../support/java.ts";
import { runProgram } from "../../../support/mouse/run-program.ts";

const support = new URL("../../../support/mouse/", import.meta.url).pathname;

/** A command that starts a program, or why it cannot be built here. */
type Start = { command: readonly [string, ...string[]] } | { missing: string };

const programs: { name: string; start: () => Start }[] = [
  {
    name: "Python: flood fill",
    start: () =>
      inPath("python3").length > 0
        ? { command: ["python3", `${support}flood_fill.py`] }
        : { missing: "Python is not installed." },
  },
  {
    name: "JavaScript: wall follower",
    start: () => ({ command: [process.execPath, `${support}wall-follower.mjs`] }),
  },
  {
    name: "C: wall follower",
    start: () =>
      built("cc", (to) => [
        ["-O1", "-o", `${to}/mouse`, `${support}wall_follower.c`],
        [`${to}/mouse`],
      ]),
  },
  {
    name: "Java: flood fill",
    start: () =>
      built("javac", (to) => [
        [...compilerOptions, "-d", to, `${support}FloodFill.java`],
        ["java", ...shortRunOptions, "-cp", to, "FloodFill"],
      ]),
  },
];

const folder = mkdtempSync(join(tmpdir(), "corridor-mouse-"));
afterAll(() => rmSync(folder, { recursive: true }));

/** Builds a program once. */
function built(
  compiler: string,
  callOf: (to: string) => [args: string[], command: [string, ...string[]]],
): Start {
  const to = join(folder, compiler);
  const [args, command] = callOf(to);
  if (existsSync(to)) return { command };
  mkdirSync(to);
  const { error, status, stderr } = spawnSync(compiler, args, { encoding: "utf8" });
  if (error === undefined && status === 0) return { command };
  rmSync(to, { recursive: true });
  if (error === undefined) throw new Error(stderr);
  return { missing: `The compiler ${compiler} is not installed.` };
}

describe.each(programs)("$name", ({ start }) => {
  it.for(mouseMazes)(
    "has the same transcript with a robot as in a grid: $name",
    async (maze, { skip }) => {
      const found = start();
      if ("missing" in found) return skip(found.missing);
      const { command } = found;
      const grid = gridOfDrawing(maze.drawing);
      const inGrid = await runProgram(command, (line, respond) => {
        const response = grid.answer(line);
        if (response !== null) respond(response);
      });
      expect([inGrid.exitCode, inGrid.log]).toEqual([0, expect.stringMatching(/^(score|turns) /)]);

      const port = new SimulatedPort(documentOf(maze));
      let answer: (line: string) => void = () => undefined;
      const problems: string[] = [];
      const session = await MouseSession.start({
        port,
        timers: new ManualTimers(),
        respond: (line) => answer(line),
        report: (sentence) => void problems.push(sentence),
        mark: () => undefined,
        onEnd: (error) => void problems.push(error.message),
      });
      const withRobot = await runProgram(command, (line, respond) => {
        answer = respond;
        return session.receive(`${line}\n`);
      });
      expect(withRobot).toEqual(inGrid);
      expect(problems).toEqual([]);
      expect(port.simulation.bumps).toBe(0);
    },
  );
});
