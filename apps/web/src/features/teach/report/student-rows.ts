/** The rows of the report's table of students. */
import type { Study, Work } from "@corridor/report";

/** What the row of a student adds up over all tasks. */
export const summed = ["attempts", "runs", "bumps", "hints"] as const;

export interface StudentRow {
  /** the name; anonymous: the number in the tables */
  student: string;
  /** seconds by task; null: the student did not open it */
  times: readonly (number | "unsolved" | null)[];
  /** null: not counted */
  sums: Readonly<Record<(typeof summed)[number], number | null>>;
}

/**
 * One row for each student with a name, in the order of the data: also for those who opened no task.
 * Then one for each row of anonymous students, whose place is the same in the table of each task.
 * @param tasks ids of the tasks, in the order of the columns
 */
export function studentRows({ work, survey }: Study, tasks: readonly string[]): StudentRow[] {
  const students = new Set(
    [...work, ...survey].map(({ student }) => student).filter((each) => each !== null),
  );
  const named = [...students].map((student) => {
    const own = work.filter((each) => each.student === student);
    return rowOf(student, own, tasks);
  });
  const anonymous = work.filter(({ student }) => student === null);
  const columns = tasks.map((task) => anonymous.filter((each) => each.task === task));
  const length = Math.max(0, ...columns.map((column) => column.length));
  const numbered = Array.from({ length }, (_, at) => {
    const own = columns.flatMap((column) => column[at] ?? []);
    return rowOf(String(at + 1), own, tasks);
  });
  return [...named, ...numbered];
}

/** @param own the work of the student */
function rowOf(student: string, own: readonly Work[], tasks: readonly string[]): StudentRow {
  const times = tasks.map((task) => {
    const found = own.find((each) => each.task === task);
    return found === undefined ? null : (found.seconds ?? ("unsolved" as const));
  });
  const sumOf = (name: (typeof summed)[number]): number | null =>
    own.reduce<number | null>(
      (sum, each) => (each[name] === null ? sum : (sum ?? 0) + each[name]),
      null,
    );
  return {
    student,
    times,
    sums: {
      attempts: sumOf("attempts"),
      runs: sumOf("runs"),
      bumps: sumOf("bumps"),
      hints: sumOf("hints"),
    },
  };
}
