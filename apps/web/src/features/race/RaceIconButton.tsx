/** "Race this run" as an icon, where its text does not fit beside "Back to now". */
import { Ghost } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import styles from "./race.module.css";
import { useRaceThisRun } from "./use-race-this-run.ts";

export function RaceIconButton() {
  const { t, ready } = useTranslation("race", { useSuspense: false });
  const { race, isBusy } = useRaceThisRun();
  if (!ready) return null;
  return (
    <IconButton
      kind="outline"
      label={t("button")}
      className={styles["shortcut"]}
      disabled={isBusy}
      onClick={race}
    >
      <Icon of={Ghost} />
    </IconButton>
  );
}
