/** Why no lesson was opened, and what to do. */
import { TriangleAlert } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import type { LessonProblem } from "./read-lesson.ts";
import styles from "./note.module.css";

export function LessonProblemNote({ problem }: { problem: LessonProblem }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const [first] = problem.code === "document" ? problem.problems : [];
  return (
    <div className={styles["problem"]} role="alert">
      <Icon of={TriangleAlert} size={18} />
      <div>
        <p>{t(`lesson.problems.${problem.code}`)}</p>
        {first !== undefined && (
          <p className={styles["detail"]}>
            {t("problem.detail", { ...first, path: first.path || t("problem.file") })}
          </p>
        )}
      </div>
    </div>
  );
}
