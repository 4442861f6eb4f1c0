import { mazePresets, writeTextMaze } from "@corridor/maze";
import { expect, it } from "vitest";
import { looksLikeFile } from "./looks-like-file.ts";

it.each(mazePresets)(
  "opens the drawn maze $id, and reports what is wrong with half of it",
  ({ maze }) => {
    const drawn = writeTextMaze(maze);
    expect(looksLikeFile(drawn)).toBe(true);
    expect(looksLikeFile(drawn.slice(0, drawn.length / 2))).toBe(true);
  },
);

it.each([
  "#S.G#",
  "o---o\n| S |\no---o\n",
  "#####\n#S G#\n#####",
  '\uFEFF {"format": "corridor/maze"',
  "{",
])("recognizes %j as a file", (text) => expect(looksLikeFile(text)).toBe(true));

it.each([
  "",
  "hello",
  "https://example.org/a-b",
  "[1]",
  "Dear Anna,\n- milk\n- bread",
  "3.14",
  "迷路",
])("treats %j as an accidental paste", (text) => expect(looksLikeFile(text)).toBe(false));
