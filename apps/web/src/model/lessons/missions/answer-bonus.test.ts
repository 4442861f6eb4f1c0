import { mazePresets, type MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { challengeOf } from "./mission.ts";
import { bonusMissions } from "./bonus-missions.ts";
import { answerBonus } from "../../../simulator/check-worker/answer-bonus.ts";

const words = { task: "Task", short: "Task", hints: [] };
const program = programPresets.find(({ id }) => id === "right-wall")?.program;
const backAndForth = programPresets.find(({ id }) => id === "back-and-forth")?.program;
const allMazes = bonusMissions.find(({ id }) => id === "all-mazes");
if (program === undefined || backAndForth === undefined || allMazes === undefined) {
  throw new Error("a preset is missing");
}
const challenge = challengeOf(allMazes, "All mazes", words);

function maze(blocks: string[], goal: [number, number] | null): MazeDocument {
  return {
    format: "corridor/maze",
    version: 1,
    name: "",
    blocks,
    start: { column: 1, row: 3, heading: "east" },
    goals: goal === null ? [] : [{ column: goal[0], row: goal[1] }],
  };
}

const room = ["#####", "#...#", "#...#", "#...#", "#####"];

describe("the bonus mission of all mazes", () => {
  it("counts the mazes that a program solves, and names those where it fails", () => {
    const answer = answerBonus({ kind: "mazes", task: challenge, program });
    expect(answer).toMatchObject({ value: { solved: 7, all: 7, failed: [] } });
    const poor = answerBonus({ kind: "mazes", task: challenge, program: backAndForth });
    // A straight corridor is all that it solves.
    expect(poor).toMatchObject({ value: { solved: 1, all: 7, ticks: 465 } });
  });

  it("counts nothing for a program with too many lines", () => {
    const [line] = program.rules;
    if (line === undefined) throw new Error("no line");
    const long = { ...program, rules: Array.from({ length: 5 }, () => line) };
    const answer = answerBonus({ kind: "mazes", task: challenge, program: long });
    expect(answer).toMatchObject({ value: { solved: 0, all: 7 } });
  });
});

describe("the bonus mission of a maze that defeats a program", () => {
  const defeat = (document: MazeDocument) =>
    answerBonus({ kind: "defeat", maze: document, program, seconds: 60 }).value;

  it("is won where the robot circles a goal in the middle", () => {
    expect(defeat(maze(room, [2, 2]))).toEqual({ state: "defeated", seconds: 60, squares: 9 });
  });

  it("is lost where the goal is beside the wall", () => {
    expect(defeat(maze(room, [3, 1]))).toMatchObject({ state: "reached" });
  });

  it("asks for a goal, and for a path to it", () => {
    expect(defeat(maze(room, null))).toEqual({ state: "no-goal" });
    const walled = ["######", "#..#.#", "#..#.#", "#..#.#", "######"];
    expect(defeat(maze(walled, [4, 1]))).toEqual({ state: "no-path" });
  });
});

describe("the trail for the finish", () => {
  it("is that of the first attempt that reaches its goal", () => {
    const [, corridor] = mazePresets;
    const [steps] = mazePresets;
    if (corridor === undefined || steps === undefined) throw new Error("no presets");
    const { value } = answerBonus({
      kind: "trail",
      seconds: 30,
      attempts: [
        { maze: steps.maze, program: backAndForth },
        { maze: corridor.maze, program },
      ],
    });
    expect(value).toMatchObject({ maze: { name: "Straight corridor" }, pose: { heading: 90 } });
    const points = value !== null && "points" in value ? value.points : [];
    expect(points.slice(0, 2)).toEqual([150, 150]);
    expect(points.at(-2)).toBeGreaterThan(900);
  });

  it("is none where no attempt does", () => {
    const [steps] = mazePresets;
    if (steps === undefined) throw new Error("no presets");
    const attempts = [{ maze: steps.maze, program: backAndForth }];
    expect(answerBonus({ kind: "trail", seconds: 5, attempts }).value).toBeNull();
  });
});
