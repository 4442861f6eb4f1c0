/** "Who drives?" Displays the driver that the simulator reports, and requests another one. */
import { List, RadioTower, User } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useRights } from "../../model/use-rights.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Segmented } from "../../ui/Segmented.tsx";

export function DriverChoice() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  // In a challenge, the lines need the room of the label. The buttons name the drivers too.
  const rights = useRights();
  const driver = useStore(run, ({ snapshot }) => snapshot?.driver ?? "program");
  const options = [
    { value: "me", label: t("drive.me"), icon: <Icon of={User} /> },
    { value: "program", label: t("drive.program"), icon: <Icon of={List} isDirectional /> },
    { value: "remote", label: t("drive.remote"), icon: <Icon of={RadioTower} /> },
  ] as const;
  // Only what the task allows. A restored run may still have another driver.
  const offered = options.filter(
    ({ value }) => value === driver || rights?.drivers.includes(value) !== false,
  );
  if (offered.length === 1) return null;
  return (
    <Segmented
      label={t("drive.who")}
      showLabel={rights === null}
      value={driver}
      options={offered}
      onChange={(next) => {
        simulator.send({ type: "driver", driver: next });
        // After a choice with the mouse, the radio loses the focus, so that the arrow keys drive
        // the robot.
        const focused = document.activeElement;
        if (focused instanceof HTMLElement && !focused.matches(":focus-visible")) focused.blur();
      }}
    />
  );
}
