/** Why no lesson was opened, and what to do. */
import { useTranslation } from "react-i18next";
import { ProblemDetail, ProblemNote } from "../../../ui/ProblemNote.tsx";
import type { LessonProblem } from "./read-lesson.ts";

export function LessonProblemNote({ problem }: { problem: LessonProblem }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const [first] = problem.code === "document" ? problem.problems : [];
  return (
    <ProblemNote>
      <p>{t(`lesson.problems.${first?.path === "version" ? "newer" : problem.code}`)}</p>
      {first !== undefined && (
        <ProblemDetail>
          {t("problem.detail", { ...first, path: first.path || t("problem.file") })}
        </ProblemDetail>
      )}
    </ProblemNote>
  );
}
