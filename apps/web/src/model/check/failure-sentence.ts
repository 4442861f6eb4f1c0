/** Why an attempt does not pass, as a fact with its numbers. */
import type { Failure, LessonTask } from "@corridor/challenge";
import type { TFunction } from "i18next";
import { roundedSides } from "../../text/compared.ts";
import { formatSeconds, localNumber } from "../../text/numbers.ts";
import { isTimeLimit, type MazeFailure } from "./attempt-result.ts";
import { mazeName } from "./maze-name.ts";

export interface CheckWords {
  /** with the namespace "check" loaded */
  t: TFunction<"check">;
  language: string;
}

/** "Tree 31 of seed 7: bump at 12.4 s, line 2" */
export function failureSentence(
  words: CheckWords,
  task: LessonTask,
  { maze, failure }: MazeFailure,
): string {
  const reason = reasonText(words, task, failure);
  if (maze === null) return reason;
  return words.t("failure.inMaze", { maze: mazeName(words.t, task, maze), reason });
}

/** "First failure: Tree 31 of seed 7, bump at 12.4 s, line 2." */
export function firstFailureSentence(
  words: CheckWords,
  task: LessonTask,
  { maze, failure }: MazeFailure,
): string {
  const reason = reasonText(words, task, failure);
  const known = { maze: mazeName(words.t, task, maze ?? 0), reason };
  // The reason for a time limit contains a sentence of its own.
  return words.t(isTimeLimit(failure) ? "failure.firstTimeLimit" : "failure.first", known);
}

/** "bump at 12.4 s, line 2" */
export function reasonText(
  { t, language }: CheckWords,
  task: LessonTask,
  failure: Failure,
): string {
  const { code, line, tick } = failure;
  const { found, needed } = numbers(failure, language);
  const { seconds } = task.checks;
  switch (code) {
    case "driver":
      return t(
        task.allowed.drivers.includes("program") ? "failure.onlyProgram" : "failure.byProgram",
      );
    case "too-many-lines":
      return t("failure.too-many-lines", { found, needed });
    case "condition-not-allowed":
      return t("failure.condition", { line: lineNumber(line) });
    case "action-not-allowed":
      return line === "default"
        ? t("failure.actionOtherwise")
        : t("failure.action", { line: lineNumber(line) });
    case "changed":
      return line === "default"
        ? t("failure.changedOtherwise")
        : t("failure.changed", { line: lineNumber(line) });
    case "bump": {
      const at = { seconds: formatSeconds(tick ?? 0, language) };
      if (line === null) return t("failure.bumpByHand", at);
      return line === "default"
        ? t("failure.bumpOtherwise", at)
        : t("failure.bump", { ...at, line: lineNumber(line) });
    }
    case "not-reached":
      return t("failure.not-reached", { seconds });
    case "not-visited":
    case "not-stopped":
    case "too-short":
      return t(`failure.${code}`, { found, needed, seconds });
  }
}

function lineNumber(line: Failure["line"]): number {
  return Number(line) + 1;
}

/** Rounds two different numbers so that the smaller one still reads as smaller. */
function numbers({ found, needed }: Failure, language: string): { found: string; needed: string } {
  const left = found ?? 0;
  const right = needed ?? 0;
  const is = left < right ? "<" : ">";
  const shown = roundedSides({ left, is, right, isTrue: left !== right }, 0);
  const text = (number: number) => localNumber(String(number), language);
  return { found: text(shown.left), needed: text(shown.right) };
}
