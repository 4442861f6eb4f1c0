/**
 * Lists why files were not opened: the place in each file, what was found, and what was expected.
 */
import type { FieldProblem } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { withKeys } from "./with-keys.ts";
import { useFileActions } from "./file-actions.ts";
import type { FileReport } from "./open-files.ts";
import styles from "./files.module.css";

interface FileProblemsProps {
  isOpen: boolean;
  reports: readonly FileReport[];
  onClose: () => void;
}

export function FileProblems({ isOpen, reports, onClose }: FileProblemsProps) {
  const { t } = useTranslation();
  const { choose } = useFileActions();
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("files.problems.title", { count: reports.length })}
      subtitle={t("files.problems.unchanged")}
      width="narrow"
      footer={reports.some(({ isTextWrong }) => isTextWrong) ? t("files.problems.fix") : undefined}
    >
      <div className={styles["reports"]}>
        {withKeys(reports, ({ file }) => file).map(
          ({ key, value: { file, problems, isTextWrong } }) => (
            <section key={key} className={styles["report"]} aria-label={file}>
              <h3 className={styles["file"]}>{file}</h3>
              <ul className={styles["problems"]}>
                {withKeys(problems, lineOf).map(
                  ({ key: line, value: { path, found, expected } }) => (
                    <li key={line} className={styles["problem"]}>
                      {isTextWrong && (
                        <span className={styles["where"]}>
                          {path === "" ? t("files.problems.whole") : path}
                        </span>
                      )}
                      <span>{t("files.problems.found", { found })}</span>
                      <span>{t("files.problems.expected", { expected })}</span>
                    </li>
                  ),
                )}
              </ul>
            </section>
          ),
        )}
        <Button
          className={styles["again"]}
          onClick={() => {
            onClose();
            choose();
          }}
        >
          {t("files.problems.again")}
        </Button>
      </div>
    </Dialog>
  );
}

function lineOf({ path, found, expected }: FieldProblem): string {
  return `${path} ${found} ${expected}`;
}
