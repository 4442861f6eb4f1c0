/** Run or Pause, Step, Reset, speed, the clock, bumps, and the story of the run. */
import { Pause, Play, RotateCcw, SkipForward } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { formatClock } from "../../text/numbers.ts";
import { Button } from "../../ui/Button.tsx";
import { Select } from "../../ui/Select.tsx";
import { speeds } from "../../worker/worker-messages.ts";
import { isPauseOffered, runOrPause } from "./run-button.ts";
import { RunStory } from "./RunStory.tsx";
import styles from "./transport.module.css";

export function Transport() {
  const { t } = useTranslation();
  return (
    <section className={styles["transport"]} aria-label={t("shell.run.controls")}>
      <div className={styles["buttons"]}>
        <RunButton />
        <StepAndReset />
        <SpeedMenu />
      </div>
      <div className={styles["telling"]}>
        <Clock />
        <RunStory />
      </div>
    </section>
  );
}

function RunButton() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  const isPause = useStore(run, ({ snapshot }) => isPauseOffered(snapshot));
  const isFault = useStore(run, ({ fault }) => fault !== null);
  const isMe = useStore(run, ({ snapshot }) => snapshot?.driver === "me");
  return (
    <Button
      kind={isPause ? "primary" : "run"}
      size="large"
      className={styles["run"]}
      icon={
        isPause ? (
          <Pause aria-hidden="true" fill="currentColor" />
        ) : (
          <Play aria-hidden="true" fill="currentColor" />
        )
      }
      disabled={isFault}
      title={isMe ? t("shell.run.runProgram") : undefined}
      aria-keyshortcuts="Control+Enter"
      onClick={() => simulator.send(runOrPause(run.getState().snapshot))}
    >
      {t(isPause ? "shell.run.pause" : "shell.run.run")}
    </Button>
  );
}

function StepAndReset() {
  const { t } = useTranslation();
  const { simulator } = useServices();
  return (
    <>
      <Button
        size="large"
        className={styles["step"]}
        icon={<SkipForward aria-hidden="true" fill="currentColor" />}
        title={t("shell.run.stepNote")}
        aria-keyshortcuts="Control+Shift+Enter"
        onClick={() => simulator.send({ type: "step" })}
      >
        {t("shell.run.step")}
      </Button>
      <Button
        size="large"
        className={styles["reset"]}
        icon={<RotateCcw aria-hidden="true" />}
        title={t("shell.run.resetNote")}
        onClick={() => simulator.send({ type: "reset" })}
      >
        <span className={styles["resetWord"]}>{t("shell.run.reset")}</span>
      </Button>
    </>
  );
}

function SpeedMenu() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  const speed = useStore(run, (state) => state.speed);
  return (
    <Select
      label={t("shell.run.speed")}
      className={styles["speed"]}
      value={String(speed)}
      options={speeds.map((each) => ({
        value: String(each),
        label: each === "max" ? t("shell.run.max") : `${each}×`,
      }))}
      onChange={(value) => {
        const next = speeds.find((each) => String(each) === value);
        if (next === undefined) return;
        run.setState({ speed: next });
        simulator.send({ type: "speed", speed: next });
      }}
    />
  );
}

function Clock() {
  const { t } = useTranslation();
  const { run } = useServices();
  const tick = useStore(run, ({ snapshot }) => snapshot?.tick ?? 0);
  const bumps = useStore(run, ({ snapshot }) => snapshot?.bumps ?? 0);
  return (
    <p className={styles["clock"]}>
      <span className={styles["time"]}>
        <span className="visually-hidden">{t("shell.run.time")} </span>
        {formatClock(tick)}
      </span>
      <span className={styles["bumps"]}>{t("shell.run.bumps", { count: bumps })}</span>
    </p>
  );
}
