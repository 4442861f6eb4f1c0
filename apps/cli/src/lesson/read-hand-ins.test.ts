import { encodeLink } from "@corridor/link";
import { describe, expect, it } from "vitest";
import { handInsOf } from "./read-hand-ins.ts";
import { programOf, sampleChallenge } from "./testing/sample-task.ts";

const program = programOf("right-wall");
function linkOf(content: Parameters<typeof encodeLink>[0]): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(link.code);
  return link.text;
}
const text = linkOf({ program });

describe("hand-ins", () => {
  it.each([
    ["the text of a link", text],
    ["a complete address", `https://corridor.example/#${text}`],
    ["a link with a maze", linkOf({ program, maze: sampleChallenge.mazes[0] ?? fail() })],
    ["a link with a challenge", linkOf({ program, challenge: sampleChallenge })],
    ["a line of a Windows file", `${text}\r`],
  ])("contain a program: %s", (_, line) => {
    expect(handInsOf(line)).toMatchObject({
      ok: true,
      value: [{ name: "line 1", read: { ok: true, value: program } }],
    });
  });

  it.each([
    ["a cut link", text.slice(0, -3), "a complete link: copy it again"],
    ["a short link", "https://corridor.example/m/bcdf", "a short link is not fetched"],
    ["a link of a challenge", linkOf({ challenge: sampleChallenge }), "a link with a program"],
    ["a name", "Anna", "one that begins with 1"],
  ])("are unreadable without a program: %s", (_, line, expected) => {
    const read = handInsOf(line);
    expect(read).toMatchObject({ ok: true, value: [{ read: { ok: false } }] });
    expect(JSON.stringify(read)).toContain(expected);
  });

  it("are named by their line, and blank lines are ignored", () => {
    const read = handInsOf(`\n  \n${text}\nx\n\n${text}\n`);
    const names = read.ok ? read.value.map(({ name }) => name) : [];
    expect(names).toEqual(["line 3", "line 4", "line 6"]);
  });

  it("are at most 10,000", () => {
    expect(handInsOf("x\n".repeat(10_000))).toMatchObject({ ok: true });
    expect(handInsOf("x\n".repeat(10_001))).toMatchObject({
      ok: false,
      problems: [{ found: "10001 lines", expected: "at most 10000 lines" }],
    });
  });
});

function fail(): never {
  throw new Error("no maze");
}
