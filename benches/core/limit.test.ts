import { countOpenCells, generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { sensorNames, type RobotReport } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { Contender } from "./contender.ts";
import { Limit } from "./limit.ts";
import { NaiveMatter } from "./naive-matter.ts";
import { Planck } from "./planck.ts";
import { Product } from "./product.ts";

function presetProgram(id: string): ProgramDocument {
  const preset = programPresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no preset ${id}`);
  return preset.program;
}

function tree(side: number, seed: number): MazeDocument {
  return generateTree({ columns: side, rows: side, seed, name: "tree" });
}

/** The largest difference of any number that both report; Infinity where a word or a count differs. */
function differenceOf(a: RobotReport, b: RobotReport): number {
  const isSame =
    a.tick === b.tick &&
    a.motion === b.motion &&
    a.bumps === b.bumps &&
    a.bumping === b.bumping &&
    a.goalReached === b.goalReached;
  if (!isSame) return Infinity;
  return Math.max(
    ...sensorNames.map((name) => Math.abs(a.sensors[name] - b.sensors[name])),
    ...(["x", "y", "heading"] as const).map((name) => Math.abs(a.pose[name] - b.pose[name])),
  );
}

/** Runs both side by side: the largest difference in any tick, and the ticks in which their cells differ. */
function compare(maze: MazeDocument, program: ProgramDocument, ticks: number) {
  const limit = new Limit(maze, program);
  const product = new Product(maze, program);
  let difference = differenceOf(limit.latest, product.latest);
  let strayed = 0;
  for (let tick = 0; tick < ticks; tick++) {
    limit.run(1);
    product.run(1);
    difference = Math.max(difference, differenceOf(limit.latest, product.latest));
    if (limit.cell !== product.cell) strayed++;
  }
  return { difference, strayed, bumps: product.latest.bumps };
}

function visitedCells(contender: Contender, ticks: number): number {
  const cells = new Set([contender.cell]);
  for (let tick = 0; tick < ticks; tick++) {
    contender.run(1);
    cells.add(contender.cell);
  }
  return cells.size;
}

describe("the limit goes the product's way, tick by tick", () => {
  it.each([
    { side: 5, seed: 1, ticks: 50_000 },
    { side: 11, seed: 1, ticks: 50_000 },
    { side: 33, seed: 2, ticks: 50_000 },
    { side: 101, seed: 3, ticks: 50_000 },
    { side: 255, seed: 4, ticks: 50_000 },
  ])("under the right-wall program in a tree of $side cells", ({ side, seed, ticks }) => {
    const { difference, strayed } = compare(tree(side, seed), presetProgram("right-wall"), ticks);
    expect(difference).toBeLessThan(1e-6);
    expect(strayed).toBe(0);
  });

  it.each(programPresets.map(({ id }) => ({ id })))("under the preset $id", ({ id }) => {
    expect(compare(tree(11, 5), presetProgram(id), 20_000).difference).toBeLessThan(1e-6);
  });

  it("into a wall, and on pushing there", () => {
    const pushing: ProgramDocument = { ...presetProgram("right-wall"), rules: [] };
    const { difference, bumps } = compare(tree(11, 1), pushing, 2_000);
    expect(bumps).toBe(1);
    expect(difference).toBeLessThan(1e-6);
  });
});

it("the limit ends at the same place whether its snapshots are made or not", () => {
  const [seen, unseen] = [0, 1].map(() => new Limit(tree(33, 6), presetProgram("right-wall")));
  seen?.run(30_000);
  unseen?.runUnseen(29_999);
  unseen?.run(1);
  expect(unseen?.latest).toEqual(seen?.latest);
});

describe("the rivals do the same work", () => {
  const rivals = [
    { name: "naive matter-js", Rival: NaiveMatter },
    { name: "planck", Rival: Planck },
  ];
  it.each(rivals)("$name visits every cell of a tree without a bump", ({ Rival }) => {
    const maze = tree(11, 1);
    const rival = new Rival(maze, presetProgram("right-wall"));
    expect(visitedCells(rival, 12_000)).toBe(countOpenCells(maze));
    expect(rival.latest.bumps).toBe(0);
  });
});
