/** The hand-ins of the class: files, and links or codes in a field. Starts the check. */
import { FileDown, FolderOpen, ListChecks } from "lucide";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { classNames } from "../../ui/class-names.ts";
import { groupedNumber } from "../../text/grouped-number.ts";
import { Button } from "../../ui/Button.tsx";
import field from "../../ui/field.module.css";
import { FieldError } from "../../ui/FieldError.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { chooseFiles } from "../../ui/incoming-files.ts";
import { countHandIns } from "./hand-in-entries.ts";
import type { HandInsWork } from "./hand-ins-work.ts";
import styles from "./hand-in-fields.module.css";

export function HandInFields({ work }: { work: HandInsWork }) {
  const { t, i18n } = useTranslation("teach", { useSuspense: false });
  const files = useStore(work.store, (state) => state.files);
  const text = useStore(work.store, (state) => state.text);
  const refusal = useStore(work.store, (state) => state.refusal);
  const id = useId();
  const count = countHandIns(files, text);
  const refusalText =
    refusal === null
      ? null
      : "found" in refusal
        ? t(`handIns.refusals.${refusal.code}`, {
            found: groupedNumber(refusal.found, i18n.language),
            most: groupedNumber(refusal.most, i18n.language),
          })
        : t(`handIns.refusals.${refusal.code}`);
  return (
    <section className={styles["fields"]} aria-label={t("handIns.heading")}>
      <div className={styles["files"]}>
        <Button
          icon={<Icon of={FolderOpen} />}
          onClick={() => chooseFiles((chosen) => void work.addFiles(chosen))}
        >
          {t("handIns.files")}
        </Button>
        {files.length > 0 ? (
          <>
            <span>{t("handIns.fileCount", { count: files.length })}</span>
            <Button kind="quiet" size="small" onClick={() => work.removeFiles()}>
              {t("handIns.removeFiles")}
            </Button>
          </>
        ) : (
          <span className={styles["drop"]}>
            <Icon of={FileDown} size={16} />
            {t("handIns.drop")}
          </span>
        )}
      </div>
      <div className={styles["lines"]}>
        <label className={field["label"]} htmlFor={id}>
          {t("handIns.lines")}
        </label>
        <textarea
          id={id}
          className={classNames(field["field"], styles["area"])}
          value={text}
          rows={4}
          dir="ltr"
          wrap="off"
          autoComplete="off"
          spellCheck={false}
          aria-describedby={refusal === null ? undefined : `${id}-error`}
          onChange={(event) => work.setText(event.target.value)}
        />
      </div>
      <div className={styles["foot"]}>
        <Button
          kind="primary"
          size="large"
          icon={<Icon of={ListChecks} />}
          onClick={() => work.startCheck()}
        >
          {count === 0 ? t("handIns.checkNone") : t("handIns.check", { count })}
        </Button>
        {refusalText !== null && <FieldError id={`${id}-error`}>{refusalText}</FieldError>}
      </div>
    </section>
  );
}
