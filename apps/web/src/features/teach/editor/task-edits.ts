/** Edits of a task that keep its fields consistent. A field that contradicts the edited one follows. */
import type { Goal, LessonTask, UnseenMazes } from "@corridor/challenge";
import type { DriverName } from "@corridor/protocol";

/** Another kind of goal, with values that suit most mazes. */
export function withGoalKind(task: LessonTask, kind: Goal["kind"]): LessonTask {
  switch (kind) {
    case "reach":
    case "visit":
      return { ...task, goal: { kind } };
    case "stop":
      return { ...task, goal: { kind, sensor: "front", from: 40, to: 60 } };
    case "drive":
      return { ...task, goal: { kind, distance: 300 } };
    case "last":
      return { ...task, goal: { kind, seconds: Math.min(30, task.checks.seconds) } };
  }
}

/** The other values of the goal follow: `from` is at most `to`, and the time limit is long enough. */
export function withGoal(task: LessonTask, goal: Goal): LessonTask {
  if (goal.kind === "last") {
    const seconds = Math.max(goal.seconds, task.checks.seconds);
    return { ...task, goal, checks: { ...task.checks, seconds } };
  }
  if (goal.kind !== "stop" || goal.from <= goal.to) return { ...task, goal };
  const isFromEdited = task.goal.kind === "stop" && task.goal.from !== goal.from;
  const bound = isFromEdited ? goal.from : goal.to;
  return { ...task, goal: { ...goal, from: bound, to: bound } };
}

/** Another time limit in each maze, in simulated seconds. */
export function withSeconds(task: LessonTask, seconds: number): LessonTask {
  const { goal } = task;
  const isTooLong = goal.kind === "last" && goal.seconds > seconds;
  return {
    ...task,
    checks: { ...task.checks, seconds },
    goal: isTooLong ? { ...goal, seconds } : goal,
  };
}

/**
 * Allows a driver, or no longer. The others stay in their order: the task opens with the first one.
 * That is a program when it is allowed anew.
 */
export function withDriver(task: LessonTask, driver: DriverName): LessonTask {
  const { drivers } = task.allowed;
  const others = drivers.filter((each) => each !== driver);
  const added = driver === "program" ? [driver, ...others] : [...others, driver];
  const next = drivers.includes(driver) ? others : added;
  return { ...task, allowed: { ...task.allowed, drivers: next } };
}

const firstUnseen: UnseenMazes = {
  kind: "tree",
  columns: 11,
  rows: 11,
  seed: 1,
  count: 50,
  pass: 45,
};

/** Changes the unseen mazes; the number to pass is at most their number. */
export function withUnseen(task: LessonTask, change: Partial<UnseenMazes>): LessonTask {
  const unseen = { ...(task.unseen ?? firstUnseen), ...change };
  return { ...task, unseen: { ...unseen, pass: Math.min(unseen.pass, unseen.count) } };
}

/**
 * A list with or without an entry, in the order of all entries.
 * @param list null stands for all
 * @param whenNull entries that null stands for
 */
export function toggled<Name extends string>(
  all: readonly Name[],
  list: readonly Name[] | null,
  name: Name,
  whenNull: readonly Name[] = all,
): Name[] {
  const before = new Set(list ?? whenNull);
  if (!before.delete(name)) before.add(name);
  return all.filter((each) => before.has(each));
}
