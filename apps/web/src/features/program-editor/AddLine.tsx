/**
 * Adds a line at the end, and counts the lines where a challenge limits them. It is disabled, with
 * the reason, where a challenge allows no more lines. Where a challenge fixes the lines, a short note
 * replaces the button. Undo and redo are beside it in a challenge, which has no program header.
 */
import { MAX_RULES } from "@corridor/program";
import { Plus } from "lucide";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { OtherMazesButton } from "./OtherMazesButton.tsx";
import { useRights } from "../../model/use-rights.ts";
import { Icon } from "../../ui/Icon.tsx";
import { classNames } from "../../ui/class-names.ts";
import styles from "./add-line.module.css";
import { UndoRedo } from "./ProgramHeader.tsx";

export function AddLine({ onAdd }: { onAdd: () => void }) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const count = useStore(workspace, ({ program }) => program.rules.length);
  const rights = useRights();
  const reasonId = useId();
  const isOff = rights !== null && count >= rights.maxLines;
  const isLimited = rights !== null && rights.maxLines < MAX_RULES;
  if (rights?.edits.has("lines") === false) {
    return (
      <div className={classNames(styles["foot"], styles["given"])}>
        <p className={styles["reason"]}>{t("lessons.linesFixed")}</p>
        <UndoRedo />
      </div>
    );
  }
  const button = (
    <button
      type="button"
      id="add-line"
      className={classNames(
        styles["add"],
        isOff && styles["off"],
        count === 0 && rights === null && styles["first"],
      )}
      disabled={isOff}
      aria-describedby={isLimited ? reasonId : undefined}
      onClick={onAdd}
    >
      <Icon of={Plus} size={18} />
      {t("program.addLine")}
      {isLimited && (
        <span id={isOff ? undefined : reasonId} className={styles["used"]} aria-hidden="true">
          {t("lessons.linesUsed", { used: count, all: rights.maxLines })}
        </span>
      )}
    </button>
  );
  return (
    <>
      {rights === null ? (
        <div className={styles["free"]}>
          {button}
          {count > 0 && <OtherMazesButton className={styles["others"]} />}
        </div>
      ) : (
        <div className={styles["foot"]}>
          {button}
          <UndoRedo />
        </div>
      )}
      {isOff && (
        <p id={reasonId} className={styles["reason"]}>
          {t("lessons.linesFull", { count: rights.maxLines })}
        </p>
      )}
    </>
  );
}
