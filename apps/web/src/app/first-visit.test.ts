import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { expect, it } from "vitest";
import { en } from "../text/en/index.ts";
import { createI18n, showLanguage } from "../text/i18n.ts";
import { firstMaze, firstProgram } from "../worker/first-work.ts";
import { firstWork } from "./first-visit.ts";

it("is the same maze and program in every language, under names of that language", async () => {
  const words = createI18n(en);
  expect(firstWork(words)).toEqual({ maze: firstMaze, program: firstProgram });
  await showLanguage(words, "ja");
  expect(firstWork(words)).toEqual({
    maze: { ...firstMaze, name: "遠回り" },
    program: { ...firstProgram, name: "例：右の壁" },
  });
});

it("is one of the ready-made mazes and algorithms, which the first screen does not carry", () => {
  expect(mazePresets.find(({ id }) => id === "long-way-round")?.maze).toEqual(firstMaze);
  const preset = programPresets.find(({ id }) => id === "right-wall")?.program;
  expect({ ...preset, name: "Example: right wall" }).toEqual(firstProgram);
});
