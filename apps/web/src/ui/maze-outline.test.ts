import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { blocksPath, edgesPath } from "./maze-outline.ts";

const maze = (...blocks: string[]): MazeDocument => ({
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks,
  start: { column: 0, row: 0, heading: "north" },
  goals: [],
});

describe("the picture of a maze", () => {
  it("draws neighbouring blocks of a row as one", () => {
    expect(blocksPath(maze("##.#", "...."))).toBe("M0 0h2v1h-2zM3 0h1v1h-1z");
  });

  it.each([
    { name: "an open maze", blocks: ["...", "..."], path: "" },
    { name: "a full maze", blocks: ["##", "##"], path: "" },
    {
      name: "one block in the middle",
      blocks: ["...", ".#.", "..."],
      path: "M1 1h1M1 2h1M1 1v1M2 1v1",
    },
    { name: "an L of blocks", blocks: ["#.", "##"], path: "M1 1h1M1 0v1" },
    { name: "a wall across", blocks: ["...", "###"], path: "M0 1h3" },
  ])("outlines $name once, without seams", ({ blocks, path }) => {
    expect(edgesPath(maze(...blocks))).toBe(path);
  });
});
