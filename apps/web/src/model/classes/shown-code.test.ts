import { CLASS_CODE_LENGTH } from "@corridor/protocol";
import { expect, it } from "vitest";
import { shownCode } from "./shown-code.ts";

it("a code has its space only when it is complete", () => {
  expect(shownCode("BCDFGH")).toBe("BCD FGH");
  expect("BCDFGH").toHaveLength(CLASS_CODE_LENGTH);
  expect(shownCode("BCD")).toBe("BCD");
  expect(shownCode("BCDF GHJK")).toBe("BCDF GHJK");
});
