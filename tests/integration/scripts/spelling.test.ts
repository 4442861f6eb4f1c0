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

  it("rejects words of the glossary in comments and names, and typing errors", () => {
    // cspell:disable
    const planted = [
      { text: "// The line mends itself.", word: "mends" },
      { text: "export function tellReader() {}", word: "tell" },
      { text: "// Recieves a snapshot.", word: "Recieves" },
    ];
    // cspell:enable
    const { isAccepted, findings } = check(planted.map(({ text }) => `${text}\n`).join(""));
    expect(isAccepted).toBe(false);
    for (const [index, { word }] of planted.entries()) {
      expect(findings).toMatch(new RegExp(`planted\\.ts:${index + 1}:.*\\b${word}\\b`));
    }
  });
});
