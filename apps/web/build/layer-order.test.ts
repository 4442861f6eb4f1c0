import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { ORDER } from "./layer-order.ts";

it("each stylesheet starts with the layer order of the base stylesheet", () => {
  const base = readFileSync(new URL("../src/ui/base.css", import.meta.url), "utf8");
  expect(base.replaceAll(/,\s+/g, ",")).toContain(ORDER);
});
