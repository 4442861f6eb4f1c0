import { MAX_CHALLENGE_TEXT_LENGTH } from "@corridor/challenge";
import { MAX_LINK_LENGTH } from "@corridor/link";
import { createRandom, generateTree, type MazeDocument } from "@corridor/maze";
import { MAX_DOCUMENT_BYTES } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { corridor, lessonWith, taskWith } from "../testing/teacher-task.ts";
import { shareSizesOf } from "./share-sizes.ts";

function trees(count: number, side: number): MazeDocument[] {
  return Array.from({ length: count }, (_, seed) =>
    generateTree({ columns: side, rows: side, seed, name: `Tree ${seed}` }),
  );
}

describe("a lesson", () => {
  it("of ten large mazes fits a link, a short link and a file", () => {
    const { link, excesses } = shareSizesOf(lessonWith(taskWith({ mazes: trees(10, 33) })));
    expect(link?.length).toBeLessThan(1_000);
    expect(excesses).toEqual({});
  });

  it("of many large mazes is too large for a short link, with its size and the part to shorten", () => {
    const lesson = lessonWith(taskWith(), taskWith({ mazes: trees(8, 101) }));
    const { link, excesses } = shareSizesOf(lesson);
    expect(link).not.toBeNull();
    expect(excesses).toEqual({
      shortLink: {
        size: JSON.stringify(lesson).length,
        limit: MAX_DOCUMENT_BYTES,
        longest: { task: 1, part: "mazes" },
      },
    });
  });

  it("of a large maze without a pattern is too long for a link", () => {
    const random = createRandom(1);
    const side = Array.from({ length: 256 });
    const noise = side.map(() => side.map(() => (random.below(2) === 0 ? "#" : ".")).join(""));
    const maze: MazeDocument = {
      ...corridor,
      blocks: [".".repeat(256), ...noise.slice(1)],
      start: { column: 0, row: 0, heading: "east" },
      goals: [{ column: 255, row: 0 }],
    };
    const { excesses } = shareSizesOf(lessonWith(taskWith({ mazes: [maze] })));
    expect(excesses.link).toMatchObject({
      limit: MAX_LINK_LENGTH,
      longest: { task: 0, part: "mazes" },
    });
    expect(excesses.link?.size).toBeGreaterThan(MAX_LINK_LENGTH);
  });

  it("of the largest mazes is too large for a file", () => {
    const open: MazeDocument = {
      ...corridor,
      blocks: Array.from({ length: 256 }, () => ".".repeat(256)),
    };
    const tasks = Array.from({ length: 4 }, () => taskWith({ mazes: Array(10).fill(open) }));
    const { link, excesses } = shareSizesOf(lessonWith(taskWith(), ...tasks));
    expect(link).toBeNull();
    expect(Object.keys(excesses)).toEqual(["shortLink", "file"]);
    expect(excesses.file).toMatchObject({
      limit: MAX_CHALLENGE_TEXT_LENGTH,
      longest: { task: 1, part: "mazes" },
    });
  });
});
