import { readMaze } from "@corridor/maze";
import { readProgram } from "@corridor/program";
import { describeProblem } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { decodeLink } from "./link.ts";
import { brokenDocuments, type BrokenDocument } from "./testing/broken-documents.ts";

const readers = { maze: readMaze, program: readProgram, link: decodeLink };

function problemsOf({ kind, text }: BrokenDocument) {
  const result = readers[kind](text);
  return result.ok ? [] : result.problems;
}

describe("a broken document", () => {
  it("occurs at least 70 times in the table, each with a unique name", () => {
    expect(brokenDocuments.length).toBeGreaterThanOrEqual(70);
    const names = brokenDocuments.map(({ kind, name }) => `${kind}: ${name}`);
    expect(new Set(names).size).toBe(names.length);
  });

  it.each(brokenDocuments)("is rejected with path, found and expected: $kind, $name", (broken) => {
    const problems = problemsOf(broken);
    expect(problems.map(({ path }) => path)).toContain(broken.path);
    const named = problems.find(({ path }) => path === broken.path);
    expect(named?.expected).toContain(broken.expected);
    for (const each of problems) {
      expect(each.found).not.toBe("");
      expect(each.expected).not.toBe("");
      expect(describeProblem(each).length).toBeLessThan(400);
      expect(describeProblem(each)).not.toContain("\n");
    }
  });

  it.each(brokenDocuments.filter(({ kind }) => kind === "link"))(
    "is rejected with its code: $name",
    ({ text, code }) => {
      expect(decodeLink(text)).toMatchObject({ ok: false, code });
    },
  );
});
