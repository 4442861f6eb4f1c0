/** Opens the path of missions at the top bar. */
import { Target } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
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
        onClick={() => setIsOpen(true)}
      >
        {t("lessons.lessons")}
      </Button>
      <LessonsDialog isOpen={isOpen} onClose={() => setIsOpen(false)} />
    </>
  );
}
