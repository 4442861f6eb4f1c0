/** The figures of a study, as the thesis of 2013 reports them. Null: not known, or too few values. */
import { paperTaskOf } from "./paper.ts";
import { deviationOf, meanOf, medianOf } from "./statistics.ts";
import { answerTo, type Study, type Work } from "./study.ts";

/** One bar of a figure. */
export interface TimeBar {
  student: string | null;
  /** null: not solved */
  seconds: number | null;
}

/** Null: no value is known. */
export type Mean = number | "too few" | null;

/** Some students, and their share of all students. */
export interface StudentShare {
  students: number;
  share: number;
}

export interface TaskReport {
  task: string;
  /** students who opened the task */
  opened: number;
  /** of all students of the report */
  solved: number;
  /** the times of the students, in the order of the data */
  bars: readonly TimeBar[];
  /** seconds of the students who solved the task */
  time: {
    mean: number | null;
    median: number | null;
    /** standard deviation of these students as a whole population */
    deviation: number | null;
    shortest: number | null;
    longest: number | null;
  };
  /** mean number of lines of the solutions, without "otherwise" */
  lines: Mean;
  /** what the paper prints about this task; null if the data are not the paper's */
  paper: {
    /** its "lines of code", which are menus */
    menus: number;
    /** the mean of its table, although its text and its data give another one, or null */
    misprint: string | null;
  } | null;
  /** students whose runs had a mistake that the diagnosis found, of all; null: not counted */
  mistaken: StudentShare | null;
  /** means of the counts of the students who opened the task */
  perStudent: Readonly<Record<CountName, Mean>>;
}

const countNames = ["attempts", "runs", "bumps", "failedChecks", "hints", "mistakes"] as const;
export type CountName = (typeof countNames)[number];

export interface QuestionReport {
  id: string;
  /** number of answers 1 to 5 */
  counts: readonly [number, number, number, number, number];
  /** students without an answer */
  skipped: number;
  mean: number | null;
  /** students with a mistake that belongs to the question, of all */
  mistakes: StudentShare | null;
}

export interface Report {
  /** all that the data mention: every share is of them */
  students: number;
  tasks: readonly TaskReport[];
  questions: readonly QuestionReport[];
}

/**
 * Calculates a report.
 * @param mistakes students with a mistake, by the ids of the questions; a teacher counts them
 */
export function reportOf(study: Study, mistakes: ReadonlyMap<string, number> = new Map()): Report {
  const students = countStudents(study);
  const tasks = new Set(study.work.map(({ task }) => task));
  return {
    students,
    tasks: [...tasks].map((task) => {
      const work = study.work.filter((each) => each.task === task);
      return taskReport(work, students);
    }),
    questions: questionIds(study).map((id) =>
      questionReport(study, id, students, mistakes.get(id)),
    ),
  };
}

/** Ids of the questions, in the order of the data. */
export function questionIds({ survey }: Study): readonly string[] {
  return [...new Set(survey.flatMap(({ answers }) => Object.keys(answers)))];
}

/** Students with a name, or the most rows without a name that one task or the survey has. */
function countStudents({ work, survey }: Study): number {
  const names = new Set<string>();
  const anonymous = new Map<string | null, number>();
  for (const { student, task } of [...work, ...survey.map((each) => ({ ...each, task: null }))]) {
    if (student === null) anonymous.set(task, (anonymous.get(task) ?? 0) + 1);
    else names.add(student);
  }
  return names.size + Math.max(0, ...anonymous.values());
}

function taskReport(work: readonly Work[], students: number): TaskReport {
  const bars = work.map(({ student, seconds }) => ({ student, seconds }));
  const seconds = known(bars.map((bar) => bar.seconds));
  const paper = paperTaskOf(bars.map((bar) => bar.seconds));
  const lines = meanOfKnown(work.map((each) => each.lines));
  const mean = (name: CountName): Mean => meanOfKnown(work.map((each) => each[name]));
  const mistakes = known(work.map((each) => each.mistakes));
  const mistaken = mistakes.filter((count) => count > 0).length;
  return {
    task: work[0]?.task ?? "",
    opened: work.length,
    solved: seconds.length,
    bars,
    time: {
      mean: meanOf(seconds),
      median: medianOf(seconds),
      deviation: deviationOf(seconds),
      shortest: seconds.length === 0 ? null : Math.min(...seconds),
      longest: seconds.length === 0 ? null : Math.max(...seconds),
    },
    lines: lines ?? paper?.lines ?? null,
    paper: paper && { menus: paper.menus, misprint: paper.misprint },
    mistaken: mistakes.length === 0 ? null : shareOf(mistaken, students),
    perStudent: {
      attempts: mean("attempts"),
      runs: mean("runs"),
      bumps: mean("bumps"),
      failedChecks: mean("failedChecks"),
      hints: mean("hints"),
      mistakes: mean("mistakes"),
    },
  };
}

function questionReport(
  { survey }: Study,
  id: string,
  students: number,
  mistaken: number | undefined,
): QuestionReport {
  const answers = known(survey.map((each) => answerTo(each, id)));
  const count = (rating: number): number => answers.filter((answer) => answer === rating).length;
  return {
    id,
    counts: [count(1), count(2), count(3), count(4), count(5)],
    // Tables of two lessons may have two answers of a student.
    skipped: Math.max(0, students - answers.length),
    mean: meanOf(answers),
    mistakes: mistaken === undefined ? null : shareOf(mistaken, students),
  };
}

/** @param all number of all students */
function shareOf(students: number, all: number): StudentShare {
  return { students, share: students / all };
}

function meanOfKnown(values: readonly (number | null)[]): Mean {
  const numbers = known(values);
  return numbers.length === 0 ? null : (meanOf(numbers) ?? "too few");
}

function known<Value>(values: readonly (Value | null)[]): Value[] {
  return values.filter((value) => value !== null);
}
