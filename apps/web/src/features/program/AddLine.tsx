/** Adds a line at the end; where a challenge allows no more, it is off and says why. */
import { Plus } from "lucide-react";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { useRights } from "../lessons/use-rights.ts";
import { classNames } from "../../ui/class-names.ts";
import ownStyles from "./add-line.module.css";
import styles from "./program.module.css";

export function AddLine({ onAdd }: { onAdd: () => void }) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const count = useStore(workspace, ({ program }) => program.rules.length);
  const rights = useRights();
  const reasonId = useId();
  const isFixed = rights?.edits.has("lines") === false;
  const isFull = rights !== null && count >= rights.maxLines;
  const isOff = isFixed || isFull;
  return (
    <>
      <button
        type="button"
        className={classNames(styles["add"], isOff && ownStyles["off"])}
        disabled={isOff}
        aria-describedby={isOff ? reasonId : undefined}
        onClick={onAdd}
      >
        <Plus size={18} aria-hidden="true" />
        {t("program.addLine")}
      </button>
      {isOff && (
        <p id={reasonId} className={ownStyles["reason"]}>
          {isFixed ? t("lessons.linesFixed") : t("lessons.linesFull", { count: rights?.maxLines })}
        </p>
      )}
    </>
  );
}
