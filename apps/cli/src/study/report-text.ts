/** Formats a report as text. */
import type { Mean, QuestionReport, Report, StudentShare, TaskReport } from "@corridor/report";

const TOO_FEW = "too few";
const BAR_SECONDS = 15;

const DEFINITIONS = [
  "Time to solve: from opening the task to the first solution that passes its check, without pauses.",
  "Solved: a run passed the check. The share is of all students of this report.",
  "Lines: of the solution, without otherwise. The paper counts menus: 1 + 2 x lines.",
  "Attempts: first runs or checks of a changed program. Runs: all starts of a program.",
  "Opened by: students who opened the task. The means below it are of these students.",
  "Mistakes: those that the diagnosis found in failed runs. With a mistake: students with at least one.",
  "SD: standard deviation of these students as a whole population.",
  "Means, medians and SD need at least 2 students.",
];

/** @returns the lines */
export function reportText(report: Report): string[] {
  const { students, tasks, questions } = report;
  return [
    students === 1 ? "1 student: too few for a mean" : `${students} students`,
    ...(tasks.length > 0 ? taskLines(tasks, students) : []),
    ...(questions.length > 0 ? questionLines(questions, students) : []),
    "",
    "Definitions",
    ...DEFINITIONS,
  ];
}

function taskLines(tasks: readonly TaskReport[], students: number): string[] {
  const notes = tasks.flatMap(({ task, time, paper }) => {
    const misprint = paper?.misprint ?? null;
    if (misprint === null) return [];
    return [
      `${task}: table 6 of the paper prints ${misprint}. Its text and its data give ${clock(time.mean)}.`,
    ];
  });
  return [
    "",
    ...table(
      ["Task", "Solved", "Mean", "Median", "SD", "Shortest", "Longest", "Lines"],
      tasks.map(({ task, solved, time, lines, paper }) => [
        task,
        `${solved} of ${students} (${percent(solved / students)})`,
        clock(time.mean),
        clock(time.median),
        clock(time.deviation),
        clock(time.shortest, "-"),
        clock(time.longest, "-"),
        typeof lines === "number"
          ? `${round(lines)} lines${paper === null ? "" : ` (${paper.menus} in the paper)`}`
          : meanText(lines),
      ]),
    ),
    ...notes,
    ...countLines(tasks, students),
    ...tasks.flatMap(barLines),
  ];
}

/** The means of the counts, if the data contain any. */
function countLines(tasks: readonly TaskReport[], students: number): string[] {
  const isCounted = tasks.some(({ perStudent }) =>
    Object.values(perStudent).some((mean) => mean !== null),
  );
  if (!isCounted) return [];
  return [
    "",
    ...table(
      [
        "Mean per student",
        "Opened by",
        "Attempts",
        "Runs",
        "Bumps",
        "Failed checks",
        "Hints",
        "Mistakes",
        "With a mistake",
      ],
      tasks.map(({ task, opened, perStudent: mean, mistaken }) => [
        task,
        `${opened} of ${students}`,
        ...[mean.attempts, mean.runs, mean.bumps, mean.failedChecks, mean.hints, mean.mistakes].map(
          meanText,
        ),
        mistaken === null ? "-" : shareText(mistaken, students),
      ]),
    ),
  ];
}

function barLines({ task, bars }: TaskReport): string[] {
  const rows = bars.map(({ student, seconds }, index) => [
    student ?? String(index + 1),
    seconds === null ? "not solved" : clock(seconds),
    "#".repeat(Math.round((seconds ?? 0) / BAR_SECONDS)),
  ]);
  return ["", `Times of ${task}, # is ${BAR_SECONDS} s`, ...table(["Student", "Time", ""], rows)];
}

function questionLines(questions: readonly QuestionReport[], students: number): string[] {
  return [
    "",
    ...table(
      [
        "Question, answers 1 (no help) to 5 (very helpful)",
        "1",
        "2",
        "3",
        "4",
        "5",
        "Skipped",
        "Mean",
        "Mistakes",
      ],
      questions.map(({ id, counts, skipped, mean, mistakes }) => [
        id,
        ...counts.map(String),
        String(skipped),
        mean === null ? TOO_FEW : mean.toFixed(1),
        mistakes === null ? "-" : shareText(mistakes, students),
      ]),
    ),
  ];
}

/** Columns of equal width: the first one to the left, numbers to the right. */
function table(header: readonly string[], rows: readonly (readonly string[])[]): string[] {
  const all = [header, ...rows];
  const widths = header.map((_, column) => Math.max(...all.map((row) => row[column]?.length ?? 0)));
  return all.map((row) =>
    row
      .map((cell, column) => {
        const width = widths[column] ?? 0;
        const isText = column === 0 || cell.startsWith("#");
        return isText ? cell.padEnd(width) : cell.padStart(width);
      })
      .join("  ")
      .trimEnd(),
  );
}

/** Minutes and seconds, such as 5:17. @param missing stands for no value */
function clock(seconds: number | null, missing = TOO_FEW): string {
  if (seconds === null) return missing;
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

function meanText(mean: Mean): string {
  return typeof mean === "number" ? round(mean) : (mean ?? "-");
}

/** @param all number of all students */
function shareText({ students, share }: StudentShare, all: number): string {
  return `${students} of ${all} (${percent(share, 1)})`;
}

function percent(share: number, digits = 0): string {
  return `${(share * 100).toFixed(digits)} %`;
}

/** One digit after the point, or none if it is zero. */
function round(value: number): string {
  return String(Math.round(value * 10) / 10);
}
