import { generateTree, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument, type Rule } from "@corridor/program";
import { paperPrograms } from "@corridor/program/testing";
import { ProgramRun, Simulation } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { LoopDetector, type LoopNotice } from "./loop-detector.ts";

function mazeOf(blocks: string[], heading: MazeDocument["start"]["heading"]): MazeDocument {
  const start = { column: 0, row: 0, heading };
  return { format: "corridor/maze", version: 1, name: "", blocks, start, goals: [] };
}

function programOf(rules: Rule[], otherwise: ProgramDocument["default"]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: otherwise, rules };
}

/** Runs a program and returns the notice with its tick. */
function noticeOf(
  maze: MazeDocument,
  program: ProgramDocument,
  seconds: number,
): (LoopNotice & { tick: number }) | null {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const detector = new LoopDetector(maze);
  for (let tick = 1; tick <= seconds * 60; tick++) {
    run.step();
    const { cell, isStopped, isManoeuvring } = simulation;
    const { line } = run;
    const action = line === "default" ? program.default : program.rules[line]?.do;
    const notice = detector.update(cell, isStopped, isManoeuvring, line, action === "stop");
    if (notice !== null) return { ...notice, tick };
  }
  return null;
}

const ring = mazeOf(["...", ".#.", "..."], "east");
/** The same ring with an exit that the robot drives past. */
const ringWithExit = mazeOf(["....", ".#.#", "...#"], "east");
const rightAtWalls = programOf(
  [{ when: { sensor: "front", is: "<", than: 51 }, do: "right 90" }],
  "forward",
);
const rightAtOpenings = programOf(
  [
    { when: { sensor: "front", is: "<", than: 51 }, do: "right 90" },
    { when: { sensor: "right", is: ">", than: 120 }, do: "delayed right 90" },
  ],
  "forward",
);

describe("LoopDetector", () => {
  it("permits loops after the robot has visited every square", () => {
    expect(noticeOf(ring, rightAtWalls, 60)).toBeNull();
  });

  it("names the line that turns the robot in circles past an unvisited square", () => {
    const notice = noticeOf(ringWithExit, rightAtOpenings, 60);
    expect(notice).toMatchObject({ kind: "circles", times: 3, line: 1 });
  });

  it("names the line that pushes against a wall, two seconds after the bump", () => {
    const notice = noticeOf(mazeOf([".."], "east"), programOf([], "forward"), 10);
    expect(notice).toMatchObject({ kind: "pushing", line: "default", cell: 1, times: 0 });
    expect((notice?.tick ?? 0) / 60).toBeCloseTo(1.25 + 2, 1);
  });

  it("names the line that turns on the spot endlessly", () => {
    const notice = noticeOf(mazeOf([".."], "east"), programOf([], "turn 180"), 30);
    expect(notice).toMatchObject({ kind: "staying", line: "default", cell: 0 });
  });

  it("permits a robot that stops on purpose", () => {
    expect(noticeOf(mazeOf([".."], "east"), programOf([], "stop"), 60)).toBeNull();
    const atWalls = programOf(
      [{ when: { sensor: "front", is: "<", than: 60 }, do: "stop" }],
      "forward",
    );
    expect(noticeOf(mazeOf(["...."], "east"), atWalls, 60)).toBeNull();
  });

  it("reports once", () => {
    const detector = new LoopDetector(mazeOf([".."], "east"));
    const notices = Array.from({ length: 1000 }, () =>
      detector.update(1, true, false, 0, false),
    ).filter(Boolean);
    expect(notices).toHaveLength(1);
  });

  it("does not report the right-wall program in a tree", () => {
    const rightWall = paperPrograms.find(({ figure }) => figure === 22);
    for (let seed = 1; seed <= 8; seed++) {
      const maze = generateTree({ columns: 11, rows: 9, seed, name: "" });
      expect(rightWall && noticeOf(maze, rightWall.program, 600)).toBeNull();
    }
  });
});
