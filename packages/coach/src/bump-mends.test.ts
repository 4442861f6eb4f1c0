import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument, type Rule } from "@corridor/program";
import { arbitraryProgram } from "@corridor/program/testing";
import { ProgramRun, Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { applyMend } from "./apply-mend.ts";
import { mendsForBump, type BumpScene } from "./bump-mends.ts";
import { storyOfBump } from "./bump-story.ts";

function mazeOf(blocks: string[], start: Partial<MazeDocument["start"]> = {}): MazeDocument {
  return {
    format: "corridor/maze",
    version: 1,
    name: "",
    blocks,
    start: { column: 0, row: 0, heading: "east", ...start },
    goals: [],
  };
}

function programOf(rules: Rule[], otherwise: ProgramDocument["default"]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: otherwise, rules };
}

/** A program on its way, with what it takes to tell a bump. */
function begin(maze: MazeDocument, program: ProgramDocument) {
  const simulation = new Simulation(maze);
  return { simulation, run: new ProgramRun(simulation, new CompiledProgram(program)) };
}

function actionOf({ rules }: ProgramDocument, line: number): Rule["do"] {
  return rules[line]?.do ?? "stop";
}

/** Runs until the first bump. @returns what the coach is told of it; null when there is none in time */
function firstBump(maze: MazeDocument, program: ProgramDocument, seconds = 30): BumpScene | null {
  const { simulation, run } = begin(maze, program);
  let decidedAt = 0;
  let part = "";
  let reading = 0;
  for (let tick = 0; tick < seconds * 60; tick++) {
    const isFree = !simulation.isManoeuvring;
    const { line } = run;
    run.decide();
    if (isFree && (run.line !== line || simulation.isManoeuvring || tick === 0)) decidedAt = tick;
    const { progress } = simulation;
    const action = run.line === "default" ? program.default : actionOf(program, run.line);
    const side = action === "reverse" ? "back" : "front";
    const now = `${decidedAt} ${progress?.part ?? 0}`;
    if (now !== part) reading = simulation.report().sensors[side];
    part = now;
    run.step();
    if (simulation.bumps === 0) continue;
    return {
      program,
      line: run.line,
      story: storyOfBump({
        action,
        part: progress?.part ?? 0,
        side,
        reading,
        needed: progress?.of ?? null,
      }),
      readings: simulation.report().sensors,
      atDecision: () => {
        const again = begin(maze, program);
        while (again.simulation.tick < decidedAt) again.run.step();
        return again.simulation;
      },
      ticks: tick + 1 - decidedAt,
      hasReachedGoal: simulation.goalTick !== null,
    };
  }
  return null;
}

/** A dead end with an opening on the left, one square before its end. */
const bend = mazeOf(["###.#", "###.#", ".....", "#####"], { row: 2 });

describe("mendsForBump", () => {
  it("changes a delayed turn that has no room into a turn on the spot", () => {
    const program = programOf(
      [{ when: { sensor: "front", is: "<", than: 60 }, do: "delayed left 90" }],
      "forward",
    );
    const scene = firstBump(mazeOf(["##.", "##.", "..."], { row: 2 }), program);
    expect(scene?.story).toMatchObject({ kind: "delay", needs: 50 });
    expect(scene?.story.free).toBeLessThan(35);
    expect(scene && mendsForBump(scene, 1)).toEqual([
      { kind: "action", line: 0, action: "left 90" },
    ]);
  });

  it("raises a number at which the robot already stands at the wall", () => {
    const program = programOf(
      [{ when: { sensor: "front", is: "<", than: 20 }, do: "left 90" }],
      "forward",
    );
    const scene = firstBump(mazeOf(["##.", "##.", "..."], { row: 2 }), program);
    expect(scene?.line).toBe("default");
    expect(scene && mendsForBump(scene, 1)).toEqual([{ kind: "number", line: 0, number: 50 }]);
  });

  it("moves the line about the wall above the line that always wins", () => {
    const program = programOf(
      [
        { when: { sensor: "back", is: ">", than: 10 }, do: "forward" },
        { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
      ],
      "stop",
    );
    const scene = firstBump(mazeOf(["##.", "##.", "..."], { row: 2 }), program);
    expect(scene?.line).toBe(0);
    expect(scene && mendsForBump(scene, 1)).toEqual([{ kind: "move", line: 1, to: 0 }]);
  });

  it("adds a line about the wall that turns to the side that is open", () => {
    const scene = firstBump(mazeOf(["##.", "##.", "..."], { row: 2 }), programOf([], "forward"));
    expect(scene?.story).toEqual({ kind: "steady", side: "front", needs: null, free: 225 });
    expect(scene && mendsForBump(scene, 1)).toEqual([
      {
        kind: "insert",
        at: 0,
        rule: { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
      },
    ]);
  });

  it("asks for more room on the side where a delayed turn drove into the wall beside it", () => {
    const program = programOf(
      [
        { when: { sensor: "left", is: ">", than: 40 }, do: "delayed left 90" },
        { when: { sensor: "front", is: "<", than: 50 }, do: "turn 180" },
      ],
      "forward",
    );
    const scene = firstBump(mazeOf(["#######", ".......", "#######"], { row: 1 }), program);
    expect(scene?.story).toMatchObject({ kind: "way-out", needs: 60, free: 25 });
    expect(scene && mendsForBump(scene, 1)).toEqual([{ kind: "number", line: 0, number: 100 }]);
  });

  it("turns back at a dead end, where a turn on the spot leads into the next wall", () => {
    const program = programOf(
      [
        { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
        { when: { sensor: "left", is: ">", than: 60 }, do: "delayed left 90" },
        { when: { sensor: "front", is: "<", than: 50 }, do: "delayed left 90" },
      ],
      "forward",
    );
    const scene = firstBump(mazeOf(["....."]), program);
    if (scene === null) throw new Error("no bump");
    expect(mendsForBump(scene, 2)).toEqual([{ kind: "action", line: 2, action: "turn 180" }]);
  });

  it("offers nothing where nothing helps", () => {
    const box = mazeOf(["."]);
    const scene = firstBump(box, programOf([], "forward"));
    expect(scene && mendsForBump(scene, 2)).toEqual([]);
  });

  it("does not take a goal that the robot had passed for the way past the wall behind it", () => {
    const corridor = { ...mazeOf(["....."]), goals: [{ column: 3, row: 0 }] };
    const program = programOf(
      [{ when: { sensor: "front", is: "<", than: 20 }, do: "stop" }],
      "forward",
    );
    const scene = firstBump(corridor, program);
    expect(scene?.hasReachedGoal).toBe(true);
    // To stop in front of the wall passes the goal as well, and gets nowhere.
    expect(scene && mendsForBump(scene, 1)).toEqual([
      {
        kind: "insert",
        at: 1,
        rule: { when: { sensor: "front", is: "<", than: 50 }, do: "right 90" },
      },
    ]);
  });

  it("whatever is offered fits the program and gets past the place", () => {
    let offered = 0;
    fc.assert(
      fc.property(arbitraryProgram, (program) => {
        const scene = firstBump(bend, program, 10);
        if (scene === null) return;
        for (const mend of mendsForBump(scene, 2)) {
          offered++;
          const mended = applyMend(program, mend);
          const simulation = scene.atDecision();
          simulation.apply({ action: "stop" });
          const run = new ProgramRun(simulation, new CompiledProgram(mended));
          for (let tick = 0; tick < scene.ticks; tick++) run.step();
          expect(simulation.bumps).toBe(0);
        }
      }),
      { seed: 11, numRuns: 300 },
    );
    expect(offered).toBeGreaterThan(10);
  });
});
