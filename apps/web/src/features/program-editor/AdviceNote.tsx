/**
 * Advice in its line: the reason, a button that applies the fix, and a button that hides the
 * advice. The style is calm because nothing is broken.
 */
import { Lightbulb, X } from "lucide";
import { useLayoutEffect, useRef } from "react";
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
  const note = useRef<HTMLDivElement>(null);
  // Below an edited line in a list that scrolls, the note would be out of sight.
  useLayoutEffect(() => {
    const line = note.current?.closest("li");
    if (line?.contains(document.activeElement)) line.scrollIntoView({ block: "nearest" });
  }, [text.reason, text.fix]);
  return (
    <div ref={note} className={styles["advice"]}>
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
