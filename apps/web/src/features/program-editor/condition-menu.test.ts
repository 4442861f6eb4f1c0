import { conditionKinds, conditionOf } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { choiceOf, DO_NOTHING, kindOfChoice } from "./condition-menu.ts";

describe("the condition menu", () => {
  it.each(conditionKinds)("finds $sensor $is $than again", (kind) => {
    expect(kindOfChoice(choiceOf(conditionOf(kind, 50)))).toBe(kind);
  });

  it("separates [Do nothing] from all conditions", () => {
    expect(choiceOf(null)).toBe(DO_NOTHING);
    expect(kindOfChoice(DO_NOTHING)).toBeNull();
  });
});
