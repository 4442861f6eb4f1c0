import { expect, it } from "vitest";
import { shownCode } from "./shown-code.ts";

it("a code has its space only when it is complete", () => {
  expect(shownCode("BCDFGH")).toBe("BCD FGH");
  expect(shownCode("BCD")).toBe("BCD");
});
