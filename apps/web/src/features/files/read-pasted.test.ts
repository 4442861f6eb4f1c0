import { expect, it } from "vitest";
import { readPasted } from "./read-pasted.ts";

const origin = "https://corridor.example";

it.each([`${origin}/#m1abc`, ` ${origin}/?lang=de#mission/one-line\n`, `${origin}/m/abcd`])(
  "opens the pasted link %j",
  (text) => expect(String(readPasted(text, origin))).toBe(text.trim()),
);

it.each([
  "",
  "hello",
  origin,
  `${origin}/`,
  `Look: ${origin}/#m1abc`,
  "https://elsewhere.example/#m1abc",
  "javascript:alert(1)",
  "#m1abc",
])("takes %j for another text", (text) => expect(readPasted(text, origin)).toBe("other"));

it("takes a drawn maze for a file", () => expect(readPasted("#S.G#", origin)).toBe("file"));
