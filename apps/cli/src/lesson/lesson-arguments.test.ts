import { describe, expect, it } from "vitest";
import { gradeArguments, gradeOptions } from "../arguments.ts";
import { InputError } from "../input-error.ts";
import { lessonArguments } from "./lesson-arguments.ts";

function parse(text: string) {
  return lessonArguments("lesson.json", gradeOptions(wordsOf(text)));
}

function wordsOf(text: string): string[] {
  return text.split(" ").filter((word) => word !== "");
}

function problemsOf(action: () => unknown): readonly string[] {
  try {
    action();
  } catch (error) {
    if (error instanceof InputError) return error.lines;
    throw error;
  }
  return [];
}

describe("the arguments of grade --challenge", () => {
  it.each([
    ["--program a b --csv", { programs: ["a", "b"], handIns: null, csv: true }],
    ["--handins -", { programs: [], handIns: "-" }],
    ["--program a --handins links.txt", { programs: ["a"], handIns: "links.txt" }],
    ["--program a --junit report.xml", { junit: "report.xml" }],
    ["--program a", { unseen: null, junit: null, required: null, csv: false }],
    ["--program a --require all", { required: 100 }],
    ["--program a --require 90%", { required: 90 }],
    [
      "--program a --unseen tree:11x9:50:7",
      { unseen: { kind: "tree", columns: 11, rows: 9, count: 50, pass: 50, seed: 7 } },
    ],
  ])("accepts %s", (text, expected) => {
    expect(parse(text)).toMatchObject({ challenge: "lesson.json", ...expected });
  });

  it.each([
    ["", "--program: found nothing, expected program files, or --handins with links"],
    ["--program a --maze m", "--maze: found with --challenge, expected without --challenge"],
    ["--program a --seconds 60", "--seconds: found with --challenge"],
    ["--program a --until goal", "--until: found with --challenge"],
    ["--program a --why", "--why: found with --challenge"],
    ["--program a --csv --junit b", "--junit: found with --csv, expected without --csv"],
    ["--program a --require most", '--require: found "most", expected all, or a whole number'],
    ["--program a --require 0%", '--require: found "0%"'],
    ["--program a --require 101%", '--require: found "101%"'],
    ["--program a --require 90", '--require: found "90"'],
    ["--program a --unseen tree", '--unseen: found "tree", expected KIND:COLUMNSxROWS:COUNT:SEED'],
    ["--program a --unseen cave:5x5:5:5", '--unseen: kind: found "cave", expected one of tree'],
    ["--program a --unseen tree:5x35:5:5", "--unseen: rows: found 35, expected a whole number"],
    ["--program a --unseen tree:6x5:5:5", "--unseen: columns: found 6, expected an odd number"],
    ["--program a --unseen tree:5x5:0:5", "--unseen: count: found 0, expected a whole number"],
    ["--program a --unseen tree:5x5:1001:5", "--unseen: count: found 1001"],
    ["--program a --unseen tree:5x5:5:1000000", "--unseen: seed: found 1000000"],
  ])("rejects %j", (text, problem) => {
    const problems = problemsOf(() => parse(text));
    expect(problems).toHaveLength(1);
    expect(problems[0]).toContain(problem);
  });

  it("are refused without --challenge", () => {
    const text = "--program a --maze m --handins h --unseen u --junit j --require all";
    expect(problemsOf(() => gradeArguments(gradeOptions(wordsOf(text))))).toEqual(
      ["handins", "unseen", "junit", "require"].map(
        (name) => `--${name}: found without --challenge, expected with --challenge`,
      ),
    );
  });
});
