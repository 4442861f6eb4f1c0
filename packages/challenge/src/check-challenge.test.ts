import { arbitraryProgram } from "@corridor/program/testing";
import type { ProgramDocument, Rule } from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { ChallengeDocument } from "./challenge-document.ts";
import { editKinds, type EditKind } from "./challenge-limits.ts";
import { checkChallenge } from "./check-challenge.ts";
import { rightsOf } from "./rights.ts";
import { sampleChallenge as sample } from "./testing/sample-challenge.ts";

const given = sample.program as ProgramDocument;
const frontRight: Rule = { when: { sensor: "front", is: "<", than: 50 }, do: "right 90" };
const solution: ProgramDocument = { ...given, rules: [frontRight] };

function withEdits(...edits: EditKind[]): ChallengeDocument {
  return { ...sample, allowed: { ...sample.allowed, edits } };
}

describe("checkChallenge", () => {
  it("passes a program that reaches the goal in every maze, and returns its counts", () => {
    const { passed, failure, mazes } = checkChallenge(sample, solution);
    expect({ passed, failure }).toEqual({ passed: true, failure: null });
    expect(mazes).toMatchObject([{ failure: null, bumps: 0, visited: 7, open: 7 }]);
    expect(mazes[0]?.distance).toBeCloseTo(577, -1);
  });

  it("reports a bump with its tick, cell, line and the readings of the decision", () => {
    const delayed: Rule = { ...frontRight, do: "delayed right 90" };
    const { failure } = checkChallenge(sample, { ...given, rules: [delayed] });
    expect(failure).toMatchObject({
      code: "bump",
      maze: 0,
      tick: 255,
      line: 0,
      place: { column: 5, row: 1 },
      needed: 0,
      found: 1,
      decision: { tick: 240, action: "delayed right 90" },
    });
    expect(failure?.decision?.readings.front).toBeCloseTo(50);
  });

  it("ignores bumps if the challenge has no bump limit", () => {
    const challenge = { ...sample, checks: { bumps: null, seconds: 5 } };
    const { failure } = checkChallenge(challenge, { ...given, rules: [] });
    expect(failure).toMatchObject({ code: "not-reached", tick: 300, line: "default", found: 5 });
  });

  it("reports the first maze that fails and still runs the others", () => {
    const [maze] = sample.mazes;
    if (maze === undefined) throw new Error("no maze");
    const mirrored = {
      ...maze,
      blocks: maze.blocks.toReversed(),
      start: { ...maze.start, row: 3 },
    };
    const challenge = {
      ...sample,
      mazes: [maze, { ...mirrored, goals: [{ column: 5, row: 1 }] }, maze],
    };
    const { passed, failure, mazes } = checkChallenge(challenge, solution);
    expect(passed).toBe(false);
    expect(failure).toMatchObject({ code: "not-reached", maze: 1 });
    expect(mazes.map((each) => each.failure === null)).toEqual([true, false, true]);
  });

  it.each<[ChallengeDocument["goal"], boolean, object]>([
    [{ kind: "visit" }, true, {}],
    [{ kind: "drive", distance: 400 }, true, {}],
    [{ kind: "drive", distance: 90_000 }, false, { code: "too-short", needed: 90_000 }],
    [{ kind: "last", seconds: 6 }, true, {}],
    [
      { kind: "stop", sensor: "front", from: 20, to: 60 },
      false,
      { code: "not-stopped", needed: 60 },
    ],
  ])("checks the goal %j", (goal, passes, failure) => {
    const verdict = checkChallenge({ ...sample, goal }, solution);
    expect(verdict.passed).toBe(passes);
    expect(verdict.failure ?? {}).toMatchObject(failure);
  });

  it("accepts the commands of a drive only if the challenge allows more than a program", () => {
    const goal = { kind: "stop", sensor: "front", from: 140, to: 160 } as const;
    const byHand = {
      ...sample,
      goal,
      allowed: { ...sample.allowed, drivers: ["me" as const] },
    };
    const drive = [
      { tick: 0, command: { action: "forward" as const } },
      { tick: 180, command: { action: "stop" as const } },
    ];
    const byScript = { ...byHand, allowed: { ...byHand.allowed, drivers: ["remote" as const] } };
    expect(checkChallenge(byHand, drive).passed).toBe(true);
    expect(checkChallenge(byScript, drive).passed).toBe(true);
    expect(checkChallenge(byHand, solution).failure?.code).toBe("driver");
    expect(checkChallenge(sample, drive).failure?.code).toBe("driver");
  });
});

describe("a program that the challenge does not allow", () => {
  const front = frontRight.when;
  it.each<[string, ChallengeDocument, Rule[], object]>([
    [
      "too many lines",
      sample,
      Array<Rule>(4).fill(frontRight),
      { code: "too-many-lines", found: 4, needed: 3 },
    ],
    [
      "a condition that is not offered",
      sample,
      [{ when: { sensor: "back", is: ">", than: 50 }, do: "forward" }],
      { code: "condition-not-allowed", line: 0 },
    ],
    [
      "an action that is not offered",
      sample,
      [frontRight, { when: front, do: "left 90" }],
      { code: "action-not-allowed", line: 1 },
    ],
    [
      "a changed number when only actions can change",
      withEdits("action"),
      given.rules.with(1, { when: { sensor: "right", is: ">", than: 61 }, do: "forward" }),
      { code: "changed", line: 1 },
    ],
    [
      "reordered lines when only numbers can change",
      withEdits("number"),
      given.rules.toReversed(),
      { code: "changed", line: 0 },
    ],
    ["a removed line", withEdits("number"), given.rules.slice(0, 1), { code: "changed", line: 1 }],
    [
      "removed lines when only the order can change",
      withEdits("order"),
      [],
      { code: "changed", line: 0 },
    ],
  ])("fails with a code: %s", (_, challenge, rules, failure) => {
    const verdict = checkChallenge(challenge, { ...given, rules });
    expect(verdict).toMatchObject({ passed: false, failure, mazes: [] });
  });

  it("can change the allowed parts of its lines: numbers, actions, their order", () => {
    const [first, second] = given.rules;
    if (first === undefined || second === undefined) throw new Error("no lines");
    const changed = (program: Partial<ProgramDocument>, ...edits: EditKind[]) =>
      checkChallenge(withEdits(...edits), { ...given, ...program }).failure?.code;
    expect(changed({ rules: [second, first] }, "order")).not.toBe("changed");
    expect(changed({ rules: [frontRight, second] }, "action")).not.toBe("changed");
    expect(changed({ rules: [second, frontRight] }, "action", "order")).not.toBe("changed");
    expect(changed({ default: "right 90" }, "otherwise")).not.toBe("changed");
    expect(changed({ default: "right 90" }, "action")).toBe("changed");
  });
});

describe("any program", () => {
  const free: ChallengeDocument = {
    ...sample,
    program: null,
    allowed: { ...sample.allowed, lines: 200, conditions: null, actions: null },
    checks: { bumps: 0, seconds: 3 },
  };

  it("gets the same verdict twice, within the time limit, with a reason if it fails", () => {
    fc.assert(
      fc.property(arbitraryProgram, (program) => {
        const verdict = checkChallenge(free, program);
        expect(checkChallenge(free, program)).toEqual(verdict);
        expect(verdict.passed).toBe(verdict.failure === null);
        for (const { ticks } of verdict.mazes) expect(ticks).toBeLessThanOrEqual(180);
      }),
      { numRuns: 100 },
    );
  });

  it("made of the editor's menu entries never violates the permissions", () => {
    const { conditions, actions, maxLines } = rightsOf(sample);
    const anyRule = fc.record({
      kind: fc.constantFrom(...conditions),
      than: fc.integer({ min: 0, max: 400 }),
      action: fc.constantFrom(...actions),
    });
    const notAllowed = ["too-many-lines", "condition-not-allowed", "action-not-allowed", "changed"];
    fc.assert(
      fc.property(fc.array(anyRule, { maxLength: maxLines }), (parts) => {
        const rules = parts.map(({ kind, than, action }): Rule => ({
          when: { sensor: kind.sensor, is: kind.is, than },
          do: action,
        }));
        const code = checkChallenge(sample, { ...given, rules }).failure?.code ?? "passed";
        expect(notAllowed).not.toContain(code);
      }),
      { numRuns: 60 },
    );
  });
});

describe("the rights of a challenge", () => {
  it("are its listed entries, in menu order", () => {
    const rights = rightsOf(sample);
    expect(rights.conditions.map(({ sensor, is }) => `${sensor} ${is}`)).toEqual([
      "front <",
      "right >",
    ]);
    expect(rights.actions).toEqual(["forward", "delayed right 90", "right 90"]);
    expect([...rights.edits].toSorted()).toEqual([...editKinds].toSorted());
  });

  it("are all menu entries if it lists none", () => {
    const rights = rightsOf({ allowed: { ...sample.allowed, conditions: null, actions: null } });
    expect(rights.conditions).toHaveLength(10);
    expect(rights.actions).toHaveLength(7);
  });
});
