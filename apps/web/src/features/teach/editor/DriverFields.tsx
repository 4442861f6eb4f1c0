/** Who may drive in the open task. The task opens with the first driver of the list. */
import { useTranslation } from "react-i18next";
import { Checkbox } from "../../../ui/Checkbox.tsx";
import { classNames } from "../../../ui/class-names.ts";
import { useDraft, useOpenTask } from "./draft-context.ts";
import field from "../../../ui/field.module.css";
import styles from "./form.module.css";
import { withDriver } from "./task-edits.ts";

const drivers = ["program", "me", "remote"] as const;

export function DriverFields() {
  const { t } = useTranslation(["lessonEditor", "words"], { useSuspense: false });
  const draft = useDraft();
  const { allowed } = useOpenTask();
  const chosen = allowed.drivers;
  return (
    <fieldset className={styles["drivers"]}>
      <legend className={classNames(field["label"], styles["legend"])}>
        {t("words:drive.who")}
      </legend>
      {drivers.map((driver) => {
        const isChosen = chosen.includes(driver);
        return (
          <Checkbox
            key={driver}
            label={t(`lessonEditor:drivers.${driver}`)}
            checked={isChosen}
            disabled={isChosen && chosen.length === 1}
            onChange={() => draft.setTask(withDriver(draft.task, driver))}
          />
        );
      })}
      {chosen.includes("me") && chosen.length > 1 && (
        <p className={styles["note"]}>{t("lessonEditor:drivers.note")}</p>
      )}
    </fieldset>
  );
}
