/** What a class did, as the report reads it: a row for each student and task. Pure. */
import type { LessonDocument } from "@corridor/challenge";
import { MAX_LABEL, type Answers, type Study, type Work } from "@corridor/report";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import type { Verifications } from "./verifier.ts";

export interface ClassStudyParts {
  lesson: LessonDocument;
  students: readonly SeenStudent[];
  verifications: Verifications;
  nameOf: (student: SeenStudent) => string;
  /** a task without a name @param task from 1 */
  taskName: (task: number) => string;
}

export function studyOf(parts: ClassStudyParts): Study {
  const { lesson, students, verifications, nameOf, taskName } = parts;
  const labels = taskLabels(lesson, taskName);
  const work = students.flatMap((student): Work[] =>
    student.tasks.flatMap((each): Work[] => {
      const task = labels[each.task - 1];
      if (task === undefined) return [];
      const verification = verifications.get(student.student)?.get(each.task);
      const claim = verification?.kind === "passes" ? verification.claim : null;
      const { attempts, runs, bumps, failedChecks, hints, mistakes, openedAt } = each;
      const ms = claim === null || openedAt === null ? null : claim.activeAt - openedAt;
      return [
        {
          student: nameOf(student),
          task,
          // Rounded down, as the clocks of the dashboard show it.
          seconds: ms === null ? null : Math.max(0, Math.floor(ms / 1_000)),
          lines: claim?.lines ?? null,
          attempts,
          runs,
          bumps,
          failedChecks,
          hints,
          mistakes,
        },
      ];
    }),
  );
  // Who opened no task and gave no answer is a student of the class, too.
  const survey = students.map((student): Answers => {
    const given = new Map(Object.entries(student.answers ?? {}));
    const answers = lesson.survey.map(({ id }) => [id, given.get(id) ?? null] as const);
    return { student: nameOf(student), answers: Object.fromEntries(answers) as Answers["answers"] };
  });
  return { work, survey };
}

/** Names of tasks can be empty or equal; labels are neither. */
function taskLabels(
  { tasks }: LessonDocument,
  taskName: ClassStudyParts["taskName"],
): readonly string[] {
  const names = tasks.map(({ name }, at) => name.trim() || taskName(at + 1));
  const numbered = names.map((name, at) => shortLabel(`${taskName(at + 1)}: ${name}`));
  const labels = names.map((name, at) =>
    names.indexOf(name) === at ? name : (numbered[at] ?? name),
  );
  // The name of a task can be the label of another one.
  return new Set(labels).size === labels.length ? labels : numbered;
}

/** The beginning of a label that is longer than a report reads. */
function shortLabel(label: string): string {
  // Half of a character is not stored as it is.
  return label
    .slice(0, MAX_LABEL)
    .replace(/[\uD800-\uDBFF]$/, "")
    .trimEnd();
}
