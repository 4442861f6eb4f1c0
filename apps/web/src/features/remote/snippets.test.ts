import { describe, expect, it } from "vitest";
import { snippet, snippetLanguages, starterLines, starterScript } from "./snippets.ts";

const KEY = "d_test-key";
/** Maximum columns of a line; Java needs wider ones. */
const widest = { python: 92, javascript: 92, java: 126, curl: 92 };

describe.each(snippetLanguages)("the script to copy in %s", (language) => {
  it("has 12 lines at most", () => {
    const lines = snippet(language, "https://host/api/v1/robots/r1", KEY).trimEnd().split("\n");
    expect(lines.length).toBeLessThanOrEqual(12);
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThanOrEqual(widest[language]);
  });
});

describe("the first script", () => {
  it("has six lines, in which a reader finds the address", () => {
    const address = "https://host/r/r1#d_test-key";
    const lines = starterScript(address).trimEnd().split("\n");
    expect(lines).toHaveLength(starterLines);
    expect(lines[0]).toBe("from corridor import Robot");
    expect(lines[1]).toContain(`"${address}"`);
  });
});
