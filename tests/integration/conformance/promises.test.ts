/** There is one check for each promise of the documentation. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { gatewayGroups, groups } from "../../../packages/conformance/src/run-checks.ts";

const PROMISES = join(import.meta.dirname, "../../../apps/relay/src/site/docs/pages/promises.md");

/** The ids of the table below a title. */
function promises(title: string): string[] {
  const [, section = ""] = readFileSync(PROMISES, "utf8").split(`\n## ${title}\n`);
  const [table = ""] = section.split(/\n#{2,3} /);
  return [...table.matchAll(/^\| `([a-z-]+)`/gm)].map(([, id = ""]) => id);
}

describe("the conformance kit", () => {
  it.each([
    { title: "What every host promises", of: groups, least: 50 },
    { title: "What every gateway promises", of: Object.values(gatewayGroups), least: 15 },
  ])("has one check for each promise of $title, and no other", ({ title, of, least }) => {
    const checks = of.flatMap((group) => group.checks.map(({ promise }) => promise));
    expect(promises(title).length).toBeGreaterThan(least);
    expect(checks.toSorted()).toEqual(promises(title).toSorted());
  });
});
