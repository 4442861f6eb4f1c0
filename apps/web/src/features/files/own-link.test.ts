import { expect, it } from "vitest";
import { ownLink } from "./own-link.ts";

const origin = "https://corridor.example";

it.each([`${origin}/#m1abc`, ` ${origin}/?lang=de#mission/one-line\n`, `${origin}/m/abcd`])(
  "opens the pasted link %j",
  (text) => expect(ownLink(text, origin)?.href).toBe(text.trim()),
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
])("takes %j for another text", (text) => expect(ownLink(text, origin)).toBeNull());
