import { expect, it } from "vitest";
import { directionOf } from "./direction.ts";

it.each([
  ["en", "ltr"],
  ["pt-BR", "ltr"],
  ["zh-Hant-TW", "ltr"],
  ["ar", "rtl"],
  ["he-IL", "rtl"],
  ["az-Arab", "rtl"],
  ["ur", "rtl"],
  [null, "auto"],
  ["qq", "auto"],
  ["abcdefgh-1", "auto"],
] as const)("a text in the language %s is written %s", (tag, direction) => {
  expect(directionOf(tag)).toBe(direction);
});
