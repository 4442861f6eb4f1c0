import { arbitraryProgram, paperPrograms } from "@corridor/program/testing";
import { MAX_LINK_LENGTH, plainActions, type Command, type TimedCommand } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { CompletionCode } from "./completion-code.ts";
import { decodeLink, encodeLink } from "./link.ts";

const mark = "0a1b2c3d4";
const rightWall = paperPrograms.find(({ figure }) => figure === 22)?.program;
if (rightWall === undefined) throw new Error("no Figure 22");
const completion: CompletionCode = { lesson: mark, task: 0, attempt: rightWall };

function textOf(completion: CompletionCode): string {
  const link = encodeLink({ completion });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

const anyCommand: fc.Arbitrary<Command> = fc.oneof(
  fc.record({ action: fc.constantFrom(...plainActions) }),
  fc.record({
    action: fc.constant("drive" as const),
    left: fc.double({ min: -1, max: 1, noNaN: true }),
    right: fc.double({ min: -1, max: 1, noNaN: true }),
  }),
);
const anyDrive: fc.Arbitrary<TimedCommand[]> = fc
  .array(fc.record({ tick: fc.integer({ min: 0, max: 5_184_000 }), command: anyCommand }))
  .map((commands) => commands.toSorted((one, other) => one.tick - other.tick));
const anyCode: fc.Arbitrary<CompletionCode> = fc.record({
  lesson: fc
    .integer({ min: 0, max: 2 ** 36 - 1 })
    .map((bits) => bits.toString(16).padStart(9, "0")),
  task: fc.integer({ min: 0, max: 11 }),
  attempt: fc.oneof(
    arbitraryProgram.map((program) => ({ ...program, name: "" })),
    anyDrive,
  ),
});

describe("a completion code", () => {
  it("decodes to an equal code", () => {
    fc.assert(
      fc.property(anyCode, (code) => {
        expect(decodeLink(textOf(code))).toEqual({ ok: true, value: { completion: code } });
      }),
      { numRuns: 200 },
    );
  });

  it("has at most 25 characters for the right-wall program of Figure 22", () => {
    expect(textOf(completion).length).toBeLessThanOrEqual(25);
  });

  it("does not contain the name of the program, which can be that of a student", () => {
    const named = { ...completion, attempt: { ...rightWall, name: "Anna" } };
    expect(textOf(named)).toBe(textOf(completion));
    expect(decodeLink(textOf(named))).toEqual({
      ok: true,
      value: { completion: { ...completion, attempt: { ...rightWall, name: "" } } },
    });
  });

  it("has about two characters for each command of a manual drive", () => {
    const attempt = Array.from({ length: 100 }, (_, at): TimedCommand => ({
      tick: 37 * at,
      command: { action: at % 2 === 0 ? "forward" : "stop" },
    }));
    expect(textOf({ ...completion, attempt }).length).toBeLessThanOrEqual(250);
  });

  it("is refused as too big for more than 4,096 commands, or more characters than a link", () => {
    const drive = (count: number, command: (at: number) => Command): CompletionCode => ({
      ...completion,
      attempt: Array.from({ length: count }, (_, tick): TimedCommand => ({
        tick,
        command: command(tick),
      })),
    });
    const stop = (): Command => ({ action: "stop" });
    expect(textOf(drive(4_096, stop)).length).toBeLessThan(MAX_LINK_LENGTH);
    const expected = { ok: false, code: "too-big", longest: null };
    expect(encodeLink({ completion: drive(4_097, stop) })).toMatchObject(expected);
    const moves = drive(4_096, (at) => ({ action: "move", distance: Math.SQRT2 * at }));
    expect(encodeLink({ completion: moves })).toMatchObject(expected);
  });
});
