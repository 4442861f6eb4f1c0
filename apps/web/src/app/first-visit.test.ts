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
    program: { ...firstProgram, name: "右の壁" },
  });
});
