import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { MAX_SCRIPT_NAME, scriptName, scriptRefSchema } from "./scripts.ts";

describe("the name of a script", () => {
  it.each([
    ["Anna", "Anna"],
    ["  two   words\n", "two words"],
    ["a\u0000b\u202ec\u200bd", "a b c d"],
    ["\u{1F916} robot", "\u{1F916} robot"],
    ["x".repeat(300), "x".repeat(MAX_SCRIPT_NAME)],
    [" \t\u0007 ", null],
    ["", null],
  ])("of %j is %j", (sent, name) => {
    expect(scriptName(sent)).toBe(name);
  });

  it("is always one that the owner's requests accept", () => {
    fc.assert(
      fc.property(fc.string({ unit: "binary", maxLength: 300 }), (sent) => {
        const name = scriptName(sent);
        return scriptRefSchema.safeParse({ driver: "Zx81qP", name, client: "Python" }).success;
      }),
    );
  });
});
