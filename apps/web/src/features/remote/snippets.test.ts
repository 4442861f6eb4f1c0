import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import {
  snippet,
  snippetFiles,
  snippetLanguages,
  starterLines,
  starterScript,
} from "./snippets.ts";

const KEY = "d_test-key";
/** Maximum columns of a line; Java needs wider ones. */
const widest = { python: 92, javascript: 92, java: 126, curl: 92 };

describe.each(snippetLanguages)("the script to copy in %s", (language) => {
  it("has 13 lines at most", () => {
    const lines = snippet(language, "https://host/api/v1/robots/r1", KEY).trimEnd().split("\n");
    expect(lines.length).toBeLessThanOrEqual(13);
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThanOrEqual(widest[language]);
  });
});

it("the page says how to save and start a script in the words of the quickstart", () => {
  const file = join(import.meta.dirname, "../../../../relay/src/site/docs/pages/quickstart.md");
  const quickstart = readFileSync(file, "utf8").replaceAll(/\s+/g, " ");
  for (const { file: name, command, program } of Object.values(snippetFiles)) {
    expect(quickstart).toContain(`as \`${name}\``);
    expect(quickstart).toContain(`with \`${command}\``);
    expect(quickstart).toContain(program === null ? name : `It needs ${program} or newer.`);
  }
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
