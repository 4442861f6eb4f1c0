import { expect, it } from "vitest";
import { readPasted } from "./read-pasted.ts";

const origin = "https://corridor.example";

it.each([
  `${origin}/#m1abc`,
  ` ${origin}/?lang=de#mission/one-line\n`,
  `${origin}/m/abcd`,
  `${origin}/r/robot#wch_key`,
])("opens the pasted link %j", (text) =>
  expect(String(readPasted(text, origin))).toBe(text.trim()),
);

it.each(["corridor.example/m/BCDF", " corridor.example/m/BCDF "])(
  "opens %j as copied from a board",
  (text) => expect(String(readPasted(text, origin))).toBe(`${origin}/m/BCDF`),
);

it.each([
  "",
  "hello",
  "Xx",
  origin,
  `${origin}/`,
  `${origin}/foo`,
  `${origin}/m/`,
  `${origin}/api/v1/mazes/abcd`,
  `Look: ${origin}/#m1abc`,
  "https://elsewhere.example/#m1abc",
  "corridor.example",
  "corridor.example.org/m/BCDF",
  "javascript:alert(1)",
  "#m1abc",
])("treats %j as other text", (text) => expect(readPasted(text, origin)).toBe("other"));

it.each(["#S.G#", "XXXXX\nXS.GX\nXXXXX", "xxxxxx\nxS  Gx\nxxxxxx", "███████\n█S   G█\n███████"])(
  "treats a drawn maze as a file: %j",
  (text) => expect(readPasted(text, origin)).toBe("file"),
);

it("does not leave the page for an address that is for a script", () =>
  expect(readPasted(`${origin}/r/robot#drv_key`, origin)).toBe("script"));
