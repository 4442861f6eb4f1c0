/** "Race this run": makes the run on the screen a ghost that starts with the robot. */
import { Ghost } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, type ButtonProps } from "../../ui/Button.tsx";
import { MenuItem } from "../../ui/Popover.tsx";
import { useRaceThisRun } from "./use-race-this-run.ts";

/** Appears once its texts are loaded. */
export function RaceButton(props: Pick<ButtonProps, "kind" | "size" | "className">) {
  const { t, ready } = useTranslation("race", { useSuspense: false });
  const { race, isBusy } = useRaceThisRun();
  if (!ready) return null;
  return (
    <Button {...props} disabled={isBusy} icon={<Icon of={Ghost} />} onClick={race}>
      {t("button")}
    </Button>
  );
}

/** The same action as a menu item. */
export function RaceMenuItem() {
  const { t, ready } = useTranslation("race", { useSuspense: false });
  const { run } = useServices();
  const hasRun = useStore(run, ({ nowTick }) => nowTick > 0);
  const { race, isBusy } = useRaceThisRun();
  if (!ready) return null;
  return (
    <MenuItem
      icon={<Icon of={Ghost} />}
      disabled={!hasRun || isBusy}
      note={t("subtitle")}
      onSelect={race}
    >
      {t("button")}
    </MenuItem>
  );
}
