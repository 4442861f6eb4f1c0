/** Describes in one sentence why an attempt fails a task. */
import type { Attempt, Failure, LessonTask } from "@corridor/challenge";

/**
 * Returns the sentence. A goal that was missed in the time limit is never called wrong, because the
 * program may reach it later.
 */
export function describeFailure(
  { code, line, needed, found }: Failure,
  task: LessonTask,
  attempt: Attempt,
): string {
  const { seconds } = task.checks;
  const place = line === "default" ? "otherwise" : `line ${(line ?? 0) + 1}`;
  switch (code) {
    case "driver":
      return "rules" in attempt
        ? "the task does not allow a program"
        : "the task allows only a program";
    case "too-many-lines":
      return `${found} lines, at most ${needed} are allowed`;
    case "condition-not-allowed":
      return `${place}: the task does not allow this condition`;
    case "action-not-allowed":
      return `${place}: the task does not allow this action`;
    case "changed":
      return `${place}: the task does not allow this change`;
    case "bump":
      return `${found} ${found === 1 ? "bump" : "bumps"}, at most ${needed} are allowed`;
    case "not-reached":
      return timeLimit(`goal not reached in ${seconds} s`);
    case "not-visited":
      return timeLimit(`${found} of ${needed} open cells visited in ${seconds} s`);
    case "not-stopped":
      return timeLimit(`robot not stopped within the bounds in ${seconds} s`);
    case "too-short":
      return timeLimit(`${Math.floor(found ?? 0)} of ${needed} cm driven in ${seconds} s`);
  }
}

function timeLimit(missed: string): string {
  return `time limit reached: ${missed}; more time may be enough`;
}
