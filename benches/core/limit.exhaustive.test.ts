import { countOpenCells, generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { sensorNames, type RobotReport } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { Variant } from "./variant.ts";
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

/** The largest difference of any number in both reports; Infinity if a state or a count differs. */
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

/**
 * Runs the limit and the product tick by tick, and counts the ticks in which their cells differ.
 */
function compare(maze: MazeDocument, program: ProgramDocument, ticks: number) {
  const limit = new Limit(maze, program);
  const product = new Product(maze, program);
  let difference = differenceOf(limit.latest, product.latest);
  let wrongCells = 0;
  for (let tick = 0; tick < ticks; tick++) {
    limit.run(1);
    product.run(1);
    difference = Math.max(difference, differenceOf(limit.latest, product.latest));
    if (limit.cell !== product.cell) wrongCells++;
  }
  return { difference, wrongCells, bumps: product.latest.bumps };
}

function visitedCells(variant: Variant, ticks: number): number {
  const cells = new Set([variant.cell]);
  for (let tick = 0; tick < ticks; tick++) {
    variant.run(1);
    cells.add(variant.cell);
  }
  return cells.size;
}

describe("the limit reports the same as the product in every tick", () => {
  it.each([
    { side: 5, seed: 1, ticks: 50_000 },
    { side: 11, seed: 1, ticks: 50_000 },
    { side: 33, seed: 2, ticks: 50_000 },
    { side: 101, seed: 3, ticks: 50_000 },
    { side: 255, seed: 4, ticks: 50_000 },
  ])("under the right-wall program in a tree of $side cells", ({ side, seed, ticks }) => {
    const { difference, wrongCells } = compare(
      tree(side, seed),
      presetProgram("right-wall"),
      ticks,
    );
    expect(difference).toBeLessThan(1e-6);
    expect(wrongCells).toBe(0);
  });

  it.each(programPresets.map(({ id }) => ({ id })))("under the preset $id", ({ id }) => {
    expect(compare(tree(11, 5), presetProgram(id), 20_000).difference).toBeLessThan(1e-6);
  });

  it("when it drives into a wall and continues to push", () => {
    const forward: ProgramDocument = { ...presetProgram("right-wall"), rules: [] };
    const { difference, bumps } = compare(tree(11, 1), forward, 2_000);
    expect(bumps).toBe(1);
    expect(difference).toBeLessThan(1e-6);
  });
});

it("the limit ends in the same state with and without snapshots", () => {
  const [limit, bare] = [0, 1].map(() => new Limit(tree(33, 6), presetProgram("right-wall")));
  limit?.run(30_000);
  bare?.runWithoutSnapshots(29_999);
  bare?.run(1);
  expect(bare?.latest).toEqual(limit?.latest);
});

describe("the peers do the same work", () => {
  const peers = [
    { name: "naive matter-js", Peer: NaiveMatter },
    { name: "planck", Peer: Planck },
  ];
  it.each(peers)("$name visits every cell of a tree without a bump", ({ Peer }) => {
    const maze = tree(11, 1);
    const peer = new Peer(maze, presetProgram("right-wall"));
    expect(visitedCells(peer, 12_000)).toBe(countOpenCells(maze));
    expect(peer.latest.bumps).toBe(0);
  });
});
