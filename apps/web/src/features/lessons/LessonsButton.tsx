/** Opens the path of missions at the top bar. */
import { Target } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import styles from "./lessons-button.module.css";
import { LessonsDialog } from "./lazy-lessons-dialog.ts";

export function LessonsButton() {
  const { t } = useTranslation();
  const [isOpen, setIsOpen] = useState(false);
  return (
    <>
      <Button
        kind="quiet"
        icon={<Target aria-hidden="true" />}
        aria-haspopup="dialog"
        className={styles["button"]}
        onClick={() => setIsOpen(true)}
      >
        <span className={styles["word"]}>{t("lessons.lessons")}</span>
      </Button>
      <LessonsDialog isOpen={isOpen} onClose={() => setIsOpen(false)} />
    </>
  );
}
