import { spawnSync } from "node:child_process";
import { describe, expect, it } from "vitest";

/** Checks a text as `npm run lint` checks a file of this name. */
function check(text: string): { isAccepted: boolean; findings: string } {
  const { status, stdout } = spawnSync(
    process.execPath,
    ["node_modules/cspell/bin.mjs", "--no-progress", "stdin://packages/geometry/src/planted.ts"],
    { cwd: new URL("../../..", import.meta.url), input: text, encoding: "utf8" },
  );
  return { isAccepted: status === 0, findings: stdout };
}

describe("spelling", () => {
  it("accepts the terms of the glossary", () => {
    expect(check("// The client reconnects and resumes the run.\n")).toMatchObject({
      isAccepted: true,
    });
  });

  // cspell:disable
  it.each([
    { text: "// The line mends itself.\n", word: "mends" },
    { text: "export function tellReader() {}\n", word: "tell" },
    { text: "// Recieves a snapshot.\n", word: "Recieves" },
    // cspell:enable
  ])("rejects $word", ({ text, word }) => {
    const { isAccepted, findings } = check(text);
    expect(isAccepted).toBe(false);
    expect(findings).toContain(word);
  });
});
