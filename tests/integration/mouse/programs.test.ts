import { describe, expect, it } from "vitest";
import {
  documentOf,
  gridOfDrawing,
  mouseMazes,
} from "../../../packages/mouse/src/testing/mouse-mazes.ts";
import { ManualTimers } from "../../../packages/mouse/src/testing/manual-timers.ts";
import { SimulatedPort } from "../../../packages/mouse/src/testing/simulated-port.ts";
import { MouseSession } from "../../../packages/mouse/src/mouse-session.ts";
import { runProgram } from "../../support/mouse/run-program.ts";

const support = new URL("../../support/mouse/", import.meta.url).pathname;
const programs = [
  { name: "Python: flood fill", command: ["python3", `${support}flood_fill.py`] },
  { name: "JavaScript: wall follower", command: [process.execPath, `${support}wall-follower.mjs`] },
] as const;

describe.each(programs)("$name", ({ command }) => {
  it.each(mouseMazes)("has the same transcript with a robot as in a grid: $name", async (maze) => {
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
  });
});
