/** Run or Pause, Step, Reset, speed, the clock, bumps, and the timeline of the run. */
import { RotateCcw, SkipBack, SkipForward } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Select } from "../../ui/Select.tsx";
import { speeds } from "../../simulator/protocol/worker-messages.ts";
import { useRights, useTool } from "../../model/use-rights.ts";
import { WriteOwnButton } from "./WriteOwnButton.tsx";
import { Clock } from "./Clock.tsx";
import { useLongPress } from "../../ui/use-long-press.ts";
import { isProgramRefused, startHint, stepBack, stepOn } from "../../model/run/run-button.ts";
import { RunButton } from "./RunButton.tsx";
import { RunStory } from "./RunStory.tsx";
import { localNumber } from "../../text/numbers.ts";
import styles from "./transport.module.css";

interface TransportProps {
  timeline: ReactNode;
  /** the controls of the past, while it is displayed */
  past: ReactNode;
}

export function Transport({ timeline, past }: TransportProps) {
  const { t } = useTranslation();
  const { run } = useServices();
  const isFresh = useStore(run, ({ nowTick }) => nowTick === 0);
  const view = useStore(run, (state) => state.view);
  const hasSpeed = useTool("speed");
  const hasTimeline = useTool("timeline");
  // While the robot runs there is no step back, and Reset displays its word instead.
  const canStepBack = useStore(
    run,
    ({ snapshot, nowTick }) => nowTick > 0 && snapshot?.state !== "running",
  );
  return (
    <section
      className={styles["transport"]}
      aria-label={t("shell.run.controls")}
      data-fresh={isFresh}
      data-back={canStepBack}
      data-view={view}
    >
      <div className={styles["buttons"]}>
        <RunButton />
        <WriteOwnButton className={styles["own"]} />
        <Step />
        {canStepBack && <StepBack />}
        <Reset />
        {hasSpeed && <SpeedMenu />}
        {view !== "now" && past}
      </div>
      <div className={styles["report"]}>
        <Clock />
        {hasTimeline && timeline}
        <RunStory />
      </div>
    </section>
  );
}

function StepBack() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  const press = useLongPress((isLong) =>
    simulator.send(stepBack(run.getState(), isLong ? "tick" : "decision")),
  );
  return (
    <IconButton
      {...press}
      kind="outline"
      size="large"
      className={styles["back"]}
      label={t("timeline.stepBack")}
    >
      <Icon of={SkipBack} fill="currentColor" />
    </IconButton>
  );
}

function Step() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  const isNow = useStore(run, ({ view }) => view === "now");
  const rights = useRights();
  const isRefused = isProgramRefused(rights) && isNow;
  const note = isRefused
    ? t(`shell.story.${startHint(rights)}`)
    : t(isNow ? "shell.run.stepNote" : "timeline.stepOnNote");
  const press = useLongPress((isLong) =>
    simulator.send(stepOn(run.getState(), isLong ? "tick" : "decision")),
  );
  return (
    <Button
      {...press}
      size="large"
      className={styles["step"]}
      icon={<Icon of={SkipForward} fill="currentColor" />}
      disabled={isRefused}
      title={note}
      aria-keyshortcuts="Control+Shift+Enter"
    >
      {t("shell.run.step")}
    </Button>
  );
}

function Reset() {
  const { t } = useTranslation();
  const { simulator } = useServices();
  return (
    <Button
      size="large"
      className={styles["reset"]}
      icon={<Icon of={RotateCcw} />}
      title={t("shell.run.resetNote")}
      onClick={() => simulator.send({ type: "reset" })}
    >
      <span className={styles["resetWord"]}>{t("shell.run.reset")}</span>
    </Button>
  );
}

function SpeedMenu() {
  const { t, i18n } = useTranslation();
  const { simulator, run } = useServices();
  const speed = useStore(run, (state) => state.speed);
  return (
    <Select
      label={t("shell.run.speed")}
      className={styles["speed"]}
      value={String(speed)}
      options={speeds.map((each) => ({
        value: String(each),
        label: each === "max" ? t("shell.run.max") : `${localNumber(String(each), i18n.language)}×`,
      }))}
      onChange={(value) => {
        const next = speeds.find((each) => String(each) === value);
        if (next === undefined) return;
        run.setState({ speed: next });
        simulator.send({ type: "speed", speed: next });
        // Removes the focus after a mouse selection, so that the drive keys move the robot instead
        // of the selection.
        const focused = document.activeElement;
        if (focused instanceof HTMLElement && !focused.matches(":focus-visible")) focused.blur();
      }}
    />
  );
}
