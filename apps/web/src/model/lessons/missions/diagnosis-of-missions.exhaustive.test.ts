/** Which mistake the diagnosis names where several lines of an answer to a mission are wrong. */
import { taskOf } from "@corridor/challenge";
import { causeLine, type Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { checkProgram } from "../testing/check-program.ts";
import { lines } from "./mission.ts";
import { causes, solved } from "./testing/causes.ts";
import type { WrongAnswer } from "./testing/wrong-answers.ts";

/** The diagnosis of the first maze that fails. */
function diagnosed({ challenge, program }: WrongAnswer): { maze: number; diagnosis: Diagnosis } {
  const { verdict, diagnoses } = checkProgram({ task: taskOf(challenge), program });
  const maze = verdict.failure?.maze ?? -1;
  const diagnosis = diagnoses[maze];
  if (diagnosis === null || diagnosis === undefined) throw new Error("no diagnosis");
  return { maze, diagnosis };
}

describe("a bump", () => {
  const named = (id: string, program: ProgramDocument) => {
    const mission = solved.find((each) => each.id === id);
    if (mission === undefined) throw new Error("no such mission");
    return diagnosed({ name: "", line: 0, challenge: mission.challenge, program }).diagnosis;
  };

  it.each(["reverse", "turn 180", "left 90", "forward"] as const)(
    "is blamed on the line that drove into the wall, whatever a line chooses that never decided (%s)",
    (unread) => {
      const program = lines(
        "forward",
        { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
        { when: { sensor: "left", is: ">", than: 60 }, do: "forward" },
        { when: { sensor: "front", is: "<", than: 50 }, do: unread },
      );
      const { event, cause } = named("faulty-line", program);
      expect(event).toMatchObject({ kind: "bump", line: 1 });
      expect(cause).toMatchObject({ kind: "action", moment: { line: 1, action: "forward" } });
    },
  );

  it("of a robot that drives back at once is blamed on the line that drives back", () => {
    const program = lines("reverse", {
      when: { sensor: "front", is: "<", than: 50 },
      do: "right 90",
    });
    const { cause } = named("right-wall", program);
    expect(cause).toMatchObject({ kind: "action", moment: { line: "default", action: "reverse" } });
  });

  it("is not blamed on a sensor, sign or number whose change solves only one of the mazes", () => {
    const when = { sensor: "front", is: ">", than: 50 } as const;
    const { cause } = named("every-maze", lines("forward", { when, do: "delayed left 90" }));
    expect(cause).toMatchObject({ kind: "action", detail: { kind: "into-wall", side: "left" } });
  });
});

describe("in a mission with several mazes", () => {
  const room = { when: { sensor: "front", is: ">", than: 50 }, do: "forward" } as const;
  const leftIsLonger = { sensor: "left", is: ">", than: "right", plus: 1 } as const;

  it.each([
    ["swapped", "right 90", "left 90"],
    ["left out", "forward", "forward"],
    ["turned round", "turn 180", "turn 180"],
  ] as const)("each maze names the one of two wrong turns that it shows (%s)", (_, left, other) => {
    const found = causes("left-or-right", lines(other, room, { when: leftIsLonger, do: left }));
    expect(found).toMatchObject([
      { kind: "action", moment: { line: 1, action: left, tick: 240 } },
      { kind: "action", moment: { line: "default", action: other, tick: 240 } },
    ]);
  });

  it("a turn to a wall is named, not the right turn of the same line before it", () => {
    const nearWall = { sensor: "front", is: "<", than: 50 } as const;
    const [cause] = causes(
      "farthest-distance",
      lines("forward", { when: nearWall, do: "left 90" }),
    );
    expect(cause).toMatchObject({
      kind: "action",
      moment: { line: 0, tick: 396 },
      detail: { kind: "into-wall", side: "left", open: "right" },
    });
  });
});

describe("an order of the lines that solves every maze", () => {
  it("comes before a delay that gets through one of them", () => {
    const mission = solved.find(({ id }) => id === "farthest-distance");
    if (mission === undefined) throw new Error("no such mission");
    const front = { when: { sensor: "front", is: ">", than: 50 }, do: "forward" } as const;
    const left = {
      when: { sensor: "left", is: ">", than: "right", plus: 1 },
      do: "left 90",
    } as const;
    const program = lines("right 90", left, front);
    const { diagnosis } = diagnosed({ name: "", line: 0, challenge: mission.challenge, program });
    expect(diagnosis.cause).toMatchObject({ kind: "order", line: 1 });
  });
});

describe("wrong answers with two changes", () => {
  it("name the missing delay also where the robot does not bump, and another line is wrong too", () => {
    const mission = solved.find(({ id }) => id === "right-wall");
    if (mission === undefined) throw new Error("no such mission");
    const { challenge, solution } = mission;
    const rules = solution.rules.map((rule, at) => ({
      ...rule,
      do: at === 0 ? ("right 90" as const) : ("turn 180" as const),
    }));
    const { diagnosis } = diagnosed({
      name: "",
      line: 0,
      challenge,
      program: { ...solution, rules },
    });
    expect(diagnosis.event.kind).toBe("late");
    expect(diagnosis.cause).toMatchObject({ kind: "not-delayed", isAtEdge: true });
    expect(causeLine(diagnosis)).toBe(0);
  });
});
