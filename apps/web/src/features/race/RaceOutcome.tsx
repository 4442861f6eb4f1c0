/**
 * The winner on the card of a solved maze, and a button that opens the table. Renders nothing
 * without a race.
 */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import styles from "./race.module.css";
import { RaceDialog } from "./RaceDialog.tsx";
import { useResultText } from "./result-text.ts";

export function RaceOutcome() {
  const { t, ready } = useTranslation("race", { useSuspense: false });
  const { race } = useServices();
  const isOn = useStore(race, ({ ghosts }) => ghosts.length > 0);
  const [isOpen, setOpen] = useState(false);
  const text = useResultText();
  if (!isOn || !ready) return null;
  return (
    <div className={styles["outcome"]}>
      <output>{text}</output>
      <Button size="small" onClick={() => setOpen(true)}>
        {t("compare")}
      </Button>
      <RaceDialog isOpen={isOpen} onClose={() => setOpen(false)} />
    </div>
  );
}
