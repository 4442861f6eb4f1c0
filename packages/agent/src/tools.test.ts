import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { listedTools } from "./tools.ts";

const pinned: unknown = JSON.parse(
  readFileSync(new URL("testing/tools.json", import.meta.url), "utf8"),
);

it("the tools, their order, names and schemas change only on purpose", () => {
  expect(JSON.parse(JSON.stringify(listedTools(true)))).toEqual(pinned);
});
