import { CELL, isBlock, type MazeDocument } from "@corridor/maze";
import { sensorNames, type Pose, type Snapshot } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { divideStage, type Zoom } from "../page/stage-layout.ts";
import { beamDirection } from "./beams.ts";
import { robotBox } from "./robot.ts";
import { placeReadings } from "./reading-placement.ts";
import {
  followScroll,
  steppedScroll,
  viewportAt,
  viewX,
  viewY,
  type Box,
  type Viewport,
} from "../drawing/viewport.ts";

/** Drawing areas of the stage, from the smallest phone to a large screen. */
const views = [
  { width: 320, height: 120 },
  { width: 320, height: 148 },
  { width: 320, height: 190 },
  { width: 320, height: 420 },
  { width: 390, height: 310 },
  { width: 390, height: 640 },
  { width: 600, height: 500 },
  { width: 844, height: 240 },
  { width: 668, height: 600 },
  { width: 1028, height: 644 },
];

/** As wide as Inter's digits at the weight of a reading. */
const widthOf =
  (sensors: Snapshot["sensors"]) =>
  (sensor: keyof Snapshot["sensors"], font: number): number =>
    Math.ceil(String(Math.round(sensors[sensor])).length * font * 0.64);

function mazeOf(blocks: readonly string[]): MazeDocument {
  return {
    format: "corridor/maze",
    version: 1,
    name: "",
    blocks: [...blocks],
    start: { column: 0, row: 0, heading: "north" },
    goals: [],
  };
}

/** Independent reference for the four sensors: advances by half a unit at a time. */
function sense(maze: MazeDocument, { x, y, heading }: Pose): Snapshot["sensors"] {
  const measure = (sensor: (typeof sensorNames)[number]): number => {
    const { dx, dy } = beamDirection(sensor, heading);
    const isOpen = (length: number): boolean =>
      !isBlock(maze, Math.floor((x + dx * length) / CELL), Math.floor((y + dy * length) / CELL));
    let length = 0;
    while (isOpen(length + 0.5)) length += 0.5;
    return length + 0.5;
  };
  const [front, right, back, left] = sensorNames.map(measure) as [number, number, number, number];
  return { front, right, back, left };
}

interface Stand {
  maze: MazeDocument;
  pose: Pose;
  viewport: Viewport;
}

function standAt(
  maze: MazeDocument,
  pose: Pose,
  view: { width: number; height: number },
  zoom: Zoom = null,
  follows = false,
): Stand {
  const size = { columns: maze.blocks[0]?.length ?? 0, rows: maze.blocks.length };
  const layout = divideStage({ maze: size, view, showRulers: true, follows, zoom });
  const scroll = layout.follows
    ? steppedScroll(layout, pose.x, pose.y)
    : layout.overflows
      ? followScroll(layout, { x: 0, y: 0 }, pose.x, pose.y)
      : { x: 0, y: 0 };
  return { maze, pose, viewport: viewportAt(layout, scroll) };
}

function overlap(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/**
 * Returns what is wrong with the readings. Plain comparisons, because an `expect` for each of them
 * takes more time than the placement.
 */
function ambiguities({ maze, pose, viewport }: Stand): string[] {
  const sensors = sense(maze, pose);
  const placed = placeReadings(viewport, { pose, sensors }, [], [], widthOf(sensors));
  const found: string[] = [];
  const names = placed.map(({ name }) => name);
  if (names.length !== 4 || sensorNames.some((name) => !names.includes(name))) {
    found.push(`only ${names.join()}`);
  }
  const origin = { x: viewX(viewport, pose.x), y: viewY(viewport, pose.y) };
  const robot = robotBox(viewport, origin);
  const { view } = viewport;
  for (const [index, label] of placed.entries()) {
    if (overlap(label, robot)) found.push(`${label.name} overlaps the robot`);
    for (const other of placed.slice(index + 1)) {
      if (overlap(label, other)) found.push(`${label.name} overlaps ${other.name}`);
    }
    const isInView =
      label.x >= 0 &&
      label.y >= 0 &&
      label.x + label.width <= view.width &&
      label.y + label.height <= view.height;
    if (!isInView) found.push(`${label.name} exceeds the view`);
    const { dx, dy } = beamDirection(label.name, pose.heading);
    const x = label.x + label.width / 2 - origin.x;
    const y = label.y + label.height / 2 - origin.y;
    // Labels are on whole pixels: half a pixel each way.
    const isAtBeam = x * dx + y * dy + 1 >= Math.abs(y * dx - x * dy);
    if (!isAtBeam) found.push(`${label.name} is not at its beam`);
  }
  return found;
}

function expectUnambiguous(stand: Stand): void {
  expect(ambiguities(stand)).toEqual([]);
}

const open = (side: number): string[] => Array.from({ length: side }, () => ".".repeat(side));
const framed = (side: number): string[] => [
  "#".repeat(side),
  ...Array.from({ length: side - 2 }, () => `#${".".repeat(side - 2)}#`),
  "#".repeat(side),
];

/** A position in a cell that is free for the robot, whatever is around the cell. */
const inCell = fc.double({ min: -25, max: 25, noNaN: true });
const heading = fc.oneof(
  fc.constantFrom(0, 90, 180, 270),
  fc.double({ min: 0, max: 359.99, noNaN: true }),
);
const view = fc.constantFrom(...views);
/** The stage has more room while a camera follows the robot. */
const hasCamera = (follows: boolean, { height }: { height: number }): boolean =>
  follows && height >= 190;

describe("the four readings are each at their beam", () => {
  it.each([7, 11, 15].flatMap((side) => [open(side), framed(side)].map((blocks) => ({ blocks }))))(
    "in the corners of a maze of $blocks.length squares ($blocks.0), on all screens",
    ({ blocks }) => {
      const from = blocks[0]?.startsWith("#") === true ? 1 : 0;
      const to = blocks.length - 1 - from;
      fc.assert(
        fc.property(
          fc.constantFrom(from, to),
          fc.constantFrom(from, to),
          inCell,
          inCell,
          heading,
          view,
          fc.boolean(),
          (column, row, x, y, degrees, size, follows) => {
            const pose = { x: column * 100 + 50 + x, y: row * 100 + 50 + y, heading: degrees };
            expectUnambiguous(standAt(mazeOf(blocks), pose, size, null, hasCamera(follows, size)));
          },
        ),
        { numRuns: 1000 },
      );
    },
  );

  it("in corridors, dead ends and rooms of every maze", () => {
    const row = fc.string({ unit: fc.constantFrom("#", "."), minLength: 9, maxLength: 9 });
    fc.assert(
      fc.property(
        fc.array(row, { minLength: 3, maxLength: 12 }),
        fc.nat(8),
        fc.nat(11),
        inCell,
        inCell,
        heading,
        view,
        fc.boolean(),
        (blocks, column, line, x, y, degrees, size, follows) => {
          fc.pre(blocks[line]?.[column] === ".");
          const pose = { x: column * 100 + 50 + x, y: line * 100 + 50 + y, heading: degrees };
          expectUnambiguous(standAt(mazeOf(blocks), pose, size, null, hasCamera(follows, size)));
        },
      ),
      { numRuns: 3000 },
    );
  });

  it("where the best position of the right reading is the only one of the back reading", () => {
    const pose = { x: 1850, y: 650, heading: 0 };
    expectUnambiguous(standAt(mazeOf(open(21)), pose, { width: 320, height: 148 }, 13));
  });

  it("in a zoomed maze", () => {
    fc.assert(
      fc.property(
        fc.nat(20),
        fc.nat(20),
        inCell,
        inCell,
        heading,
        view,
        fc.oneof(fc.constant("fit" as const), fc.integer({ min: 10, max: 200 })),
        (column, row, x, y, degrees, size, zoom) => {
          // Larger cells leave no room in the view beside the robot.
          fc.pre(zoom === "fit" || zoom <= Math.min(size.width, size.height) / 2);
          const pose = { x: column * 100 + 50 + x, y: row * 100 + 50 + y, heading: degrees };
          expectUnambiguous(standAt(mazeOf(open(21)), pose, size, zoom));
        },
      ),
      { numRuns: 1000 },
    );
  });
});
