/** Opens the table of the race, and shows the number of ghosts. */
import { Ghost } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import styles from "./race.module.css";
import { RaceDialog } from "./RaceDialog.tsx";

export function RaceChip() {
  const { t, ready } = useTranslation("race", { useSuspense: false });
  const { race } = useServices();
  const count = useStore(race, ({ ghosts }) => ghosts.length);
  const [isOpen, setOpen] = useState(false);
  if (!ready) return null;
  return (
    <>
      <Button
        size="small"
        className={styles["chip"]}
        icon={<Icon of={Ghost} />}
        title={t("chip", { count })}
        aria-label={t("chip", { count })}
        onClick={() => setOpen(true)}
      >
        {count}
      </Button>
      <RaceDialog isOpen={isOpen} onClose={() => setOpen(false)} />
    </>
  );
}
