/** The lines with which students start. */
import { isSameBehaviour, programPresets } from "@corridor/program";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../../ui/Button.tsx";
import { Dialog } from "../../../ui/Dialog.tsx";
import { Select } from "../../../ui/Select.tsx";
import { useDraft, useOpenTask } from "./draft-context.ts";
import field from "../../../ui/field.module.css";
import styles from "./form.module.css";

/** @param lines the editor of the lines */
export function StartLines({ lines }: { lines: ReactNode }) {
  const { t } = useTranslation(["lessonEditor", "words"], { useSuspense: false });
  const draft = useDraft();
  const { program } = useOpenTask();
  const [isOpen, setOpen] = useState(false);
  const preset = programPresets.find(
    (each) => program !== null && isSameBehaviour(each.program, program),
  );
  const own = program === null || preset !== undefined ? [] : [{ value: "own" }];
  return (
    <div className={styles["choice"]}>
      <span className={field["label"]} aria-hidden="true">
        {t("lessonEditor:start.label")}
      </span>
      <div className={styles["row"]}>
        <Select
          label={t("lessonEditor:start.label")}
          value={program === null ? "none" : (preset?.id ?? "own")}
          options={[
            { value: "none", label: t("lessonEditor:start.none") },
            ...own.map(({ value }) => ({
              value,
              label: t("lessonEditor:start.own", { count: program?.rules.length ?? 0 }),
            })),
            ...programPresets.map(({ id }) => ({
              value: id,
              label: t(`words:program.preset.${id}.name`),
            })),
          ]}
          onChange={(choice) => {
            const chosen = programPresets.find(({ id }) => id === choice);
            if (choice === "none") draft.editTask({ program: null });
            else if (chosen !== undefined) {
              const name = t(`words:program.preset.${chosen.id}.name`);
              draft.editTask({ program: { ...chosen.program, name } });
            }
          }}
        />
        <Button size="small" onClick={() => setOpen(true)}>
          {t("lessonEditor:start.edit")}
        </Button>
      </div>
      <Dialog
        isOpen={isOpen}
        onClose={() => setOpen(false)}
        title={t("lessonEditor:start.label")}
        width="narrow"
      >
        {lines}
      </Dialog>
    </div>
  );
}
