/** What a class did, as the report reads it: a row for each student and task. Pure. */
import type { LessonDocument } from "@corridor/challenge";
import type { Answers, Study, Work } from "@corridor/report";
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
    const answers = lesson.survey.map(({ id }) => [id, student.answers?.[id] ?? null] as const);
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
  return names.map((name, at) =>
    names.indexOf(name) === at ? name : `${taskName(at + 1)}: ${name}`,
  );
}
