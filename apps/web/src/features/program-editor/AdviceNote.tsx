/**
 * Advice in its line: the reason, a button that applies the fix, and a button that hides the
 * advice. The style is calm because nothing is broken.
 */
import { Lightbulb, X } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import styles from "./line-notes.module.css";
import type { AdviceText } from "../../model/advice/advice-text.ts";

export interface AdviceNoteProps {
  text: AdviceText;
  /** applies the fix; absent in a challenge, where the student finds the change */
  onFix?: (() => void) | undefined;
  onHide: () => void;
}

export function AdviceNote({ text, onFix, onHide }: AdviceNoteProps) {
  const { t } = useTranslation();
  return (
    <div className={styles["advice"]}>
      <Icon of={Lightbulb} size={16} />
      <p>{text.reason}</p>
      {text.fix !== null && onFix !== undefined && (
        <Button size="small" className={styles["fix"]} onClick={onFix}>
          {text.fix}
        </Button>
      )}
      <IconButton label={t("program.advice.hide")} onClick={onHide}>
        <Icon of={X} />
      </IconButton>
    </div>
  );
}
