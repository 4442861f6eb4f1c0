import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import type { VectorContext } from "../drawing/drawing-context.ts";
import { readPalette } from "../drawing/palette.ts";
import { beamDirection } from "./beams.ts";
import { bumpMark } from "./bumps.ts";
import { isOnReachedGoal } from "./celebration.ts";
import { drawStart } from "./places.ts";
import { faceOf } from "./robot.ts";
import { numberStep } from "./rulers.ts";
import { visibleMarks } from "./beam-labels.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["..#", "...", "..."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [],
};

describe("a bump", () => {
  it.each([
    { name: "ahead", pose: { x: 175, y: 50, heading: 90 }, mark: { x: 200, y: 50 } },
    { name: "behind", pose: { x: 175, y: 50, heading: 270 }, mark: { x: 200, y: 50 } },
    { name: "at the edge", pose: { x: 150, y: 275, heading: 180 }, mark: { x: 150, y: 300 } },
    { name: "at a corner", pose: { x: 185, y: 118, heading: 60 }, mark: { x: 200, y: 100 } },
    { name: "in a nook", pose: { x: 275, y: 275, heading: 90 }, mark: { x: 300, y: 275 } },
    { name: "nowhere", pose: { x: 150, y: 150, heading: 0 }, mark: { x: 150, y: 150 } },
  ])("$name is marked at the contact point", ({ pose, mark }) => {
    const { x, y } = bumpMark(maze, pose);
    expect(x).toBeCloseTo(mark.x, 6);
    expect(y).toBeCloseTo(mark.y, 6);
  });
});

describe("a beam", () => {
  it.each([
    { sensor: "front", heading: 0, dx: 0, dy: -1 },
    { sensor: "right", heading: 0, dx: 1, dy: 0 },
    { sensor: "back", heading: 90, dx: -1, dy: 0 },
    { sensor: "left", heading: 180, dx: 1, dy: 0 },
  ] as const)("of $sensor at heading $heading goes $dx, $dy", ({ sensor, heading, dx, dy }) => {
    const direction = beamDirection(sensor, heading);
    expect(direction.dx).toBeCloseTo(dx, 12);
    expect(direction.dy).toBeCloseTo(dy, 12);
  });
});

describe("the robot's face", () => {
  it.each([
    { bumping: false, goalReached: false, face: "driving" },
    { bumping: false, goalReached: true, face: "solved" },
    { bumping: true, goalReached: false, face: "bumped" },
    { bumping: true, goalReached: true, face: "bumped" },
  ])("is $face", ({ face, ...snapshot }) => {
    expect(faceOf(snapshot)).toBe(face);
  });
});

describe("the rays of a celebration", () => {
  const goals = [{ column: 2, row: 1 }];
  it.each([
    { name: "shine on the goal", x: 210, y: 150, goalReached: true, shine: true },
    { name: "go out where the robot leaves it", x: 199, y: 150, goalReached: true, shine: false },
    { name: "wait until it is reached", x: 210, y: 150, goalReached: false, shine: false },
  ])("$name", ({ x, y, goalReached, shine }) => {
    expect(isOnReachedGoal({ goals }, { goalReached, pose: { x, y, heading: 0 } })).toBe(shine);
  });
});

describe("the label of the start", () => {
  it.each([
    { name: "stands below the robot in a large square", side: 80, words: ["Start"] },
    { name: "is left out where the robot would cover half of it", side: 70, words: [] },
  ])("$name", ({ side, words }) => {
    const written: string[] = [];
    const pen = new Proxy(
      {},
      {
        get: (_, name) => (text: string) => void (name === "fillText" && written.push(text)),
        set: () => true,
      },
    ) as VectorContext;
    const palette = readPalette(() => "black");
    drawStart(pen, { x: 0, y: 0, width: side, height: side }, palette, maze.start, "Start");
    expect(written).toEqual(words);
  });
});

describe("the rulers", () => {
  it.each([
    { cellPx: 84, step: 1 },
    { cellPx: 30, step: 2 },
    { cellPx: 10, step: 5 },
  ])("number every $step squares of $cellPx px", ({ cellPx, step }) => {
    expect(numberStep(cellPx, 44)).toBe(step);
  });
});

describe("the marks on the beams", () => {
  const limits = [0, 1].map((line) => ({
    line,
    sensor: "front" as const,
    distance: 50,
    isRunning: line === 1,
  }));
  it.each([
    { name: "all stand in a large maze", scale: 0.8, isAtBump: false, lines: [0, 1] },
    { name: "all stay at a bump there", scale: 0.8, isAtBump: true, lines: [0, 1] },
    { name: "the running line's stands in a small one", scale: 0.3, isAtBump: false, lines: [1] },
    { name: "none hides a bump there", scale: 0.3, isAtBump: true, lines: [] },
  ])("$name", ({ scale, isAtBump, lines }) => {
    expect(visibleMarks(limits, scale, isAtBump).map(({ line }) => line)).toEqual(lines);
  });
});
