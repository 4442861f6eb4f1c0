import { describe, expect, it } from "vitest";
import { cellPath } from "./cell-path.ts";

describe("the path of a robot", () => {
  it.each([
    { name: "no move", positions: [150, 150], path: "" },
    { name: "a move within a cell", positions: [150, 150, 190, 110], path: "" },
    {
      name: "moves in all directions",
      positions: [150, 150, 550, 150, 550, 350, 250, 350, 250, 250],
      path: "e4s2w3n1",
    },
    { name: "corners within one direction", positions: [150, 150, 250, 150, 450, 160], path: "e3" },
    { name: "a way back", positions: [150, 150, 350, 150, 150, 150], path: "e2w2" },
  ])("is $path after $name", ({ positions, path }) => {
    expect(cellPath(positions)).toBe(path);
  });

  it("contains the newest moves that fit", () => {
    const positions = [50, 50];
    for (let turn = 0; turn < 300; turn++) positions.push(turn % 2 === 0 ? 1_150 : 50, 50);
    const path = cellPath(positions);
    expect(path.length).toBeLessThanOrEqual(400);
    expect(path.length).toBeGreaterThan(395);
    expect(path.endsWith("e11w11")).toBe(true);
  });
});
