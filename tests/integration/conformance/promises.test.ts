/** There is one check for each promise of the documentation. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { groups } from "../../../packages/conformance/src/run-checks.ts";

const PROMISES = join(import.meta.dirname, "../../../apps/relay/src/site/docs/pages/promises.md");

/** The ids of the table below "What every host promises". */
function promises(): string[] {
  const [, section = ""] = readFileSync(PROMISES, "utf8").split("\n## What every host promises\n");
  const [table = ""] = section.split(/\n#{2,3} /);
  return [...table.matchAll(/^\| `([a-z-]+)`/gm)].map(([, id = ""]) => id);
}

describe("the conformance kit", () => {
  it("has one check for each promise of the documentation, and no other", () => {
    const checks = groups.flatMap((group) => group.checks.map(({ promise }) => promise));
    expect(promises().length).toBeGreaterThan(50);
    expect(checks.toSorted()).toEqual(promises().toSorted());
  });
});
