import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { expect, it } from "vitest";
import { en } from "../../text/en/index.ts";
import { createI18n, showLanguage } from "../../text/i18n.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { firstProject } from "./first-visit.ts";

it("is the same maze and program in every language, with translated names", async () => {
  const words = createI18n(en);
  expect(firstProject(words)).toEqual({ maze: firstMaze, program: firstProgram });
  await showLanguage(words, "ja");
  expect(firstProject(words)).toEqual({
    maze: { ...firstMaze, name: "遠回り" },
    program: { ...firstProgram, name: "例：右の壁" },
  });
});

it("is one of the presets, which the first screen does not load", () => {
  expect(mazePresets.find(({ id }) => id === "long-way-round")?.maze).toEqual(firstMaze);
  const preset = programPresets.find(({ id }) => id === "right-wall")?.program;
  expect({ ...preset, name: "Example: right wall" }).toEqual(firstProgram);
});
