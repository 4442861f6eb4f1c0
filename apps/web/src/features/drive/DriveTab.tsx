/**
 * The Drive tab of the phone, where the task allows to drive by hand: readings in a row, big keys
 * under the thumbs, and the current driver.
 */
import { Pause, Play, RotateCcw } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { useRights } from "../../model/use-rights.ts";
import { runButton } from "../../model/run/run-button.ts";
import { DrivePad } from "./DrivePad.tsx";
import styles from "./drive-tab.module.css";
import type { HoldStore } from "./hold-store.ts";
import { SensorCross } from "./SensorCross.tsx";

export function DriveTab({ hold }: { hold: HoldStore }) {
  const { t } = useTranslation(["words", "runDetails"], { useSuspense: false });
  const { run } = useServices();
  const status = useStore(run, ({ snapshot }) => {
    const { driver, state } = snapshot ?? { driver: "program", state: "paused" };
    return driver === "program" && state !== "running" ? "programRests" : driver;
  });
  const isNow = useStore(run, ({ view }) => view === "now");
  const rights = useRights();
  return (
    <div className={styles["tab"]}>
      <div className={styles["head"]}>
        <h2 className={styles["caption"]}>{t("drive.hold")}</h2>
        <SensorCross look="row" />
      </div>
      <div className={styles["pad"]}>
        <DrivePad hold={hold} caps="words" />
        {isNow && <Reset />}
      </div>
      <div className={styles["foot"]}>
        <p className={styles["status"]}>{t(`drive.status.${status}`)}</p>
        {/* The transport has its own button in the past; some missions refuse the program. */}
        {isNow && rights?.drivers.includes("program") !== false && <RunProgram />}
      </div>
    </div>
  );
}

/** A student who drives by hand starts again here, too: in a corner that has no key. */
function Reset() {
  const { t } = useTranslation();
  const { simulator } = useServices();
  return (
    <IconButton
      label={t("shell.run.reset")}
      kind="outline"
      size="large"
      className={styles["reset"]}
      onClick={() => simulator.send({ type: "reset" })}
    >
      <Icon of={RotateCcw} />
    </IconButton>
  );
}

/** The run button of the transport, for a layout without room for the transport. */
function RunProgram() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  const isPause = useStore(run, (state) => runButton(state) === "pause");
  const isFault = useStore(run, ({ fault }) => fault !== null);
  const icon = isPause ? Pause : Play;
  return (
    <Button
      kind={isPause ? "primary" : "run"}
      size="large"
      className={styles["runProgram"]}
      icon={<Icon of={icon} fill="currentColor" />}
      disabled={isFault}
      aria-keyshortcuts="Control+Enter"
      onClick={() => simulator.send({ type: isPause ? "pause" : "run" })}
    >
      {t(isPause ? "shell.run.pause" : "shell.run.runProgram")}
    </Button>
  );
}
