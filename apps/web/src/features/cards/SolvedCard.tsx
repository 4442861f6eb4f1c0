/** The card for a reached goal: the figures of the run, and the next steps. */
import { countLines } from "@corridor/program";
import type { DriverName, Pose } from "@corridor/protocol";
import { Flag, History, Share } from "lucide";
import { useMemo, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { mazeCount, openTask } from "../../model/challenge/challenge-store.ts";
import { useTool } from "../../model/use-rights.ts";
import { useServices } from "../../model/use-services.ts";
import { useWaited } from "../../model/use-waited.ts";
import { allOf } from "../../text/all-of.ts";
import { formatClock, formatSeconds } from "../../text/numbers.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import styles from "./cards.module.css";
import { FloatingCard } from "./FloatingCard.tsx";
import { Onward } from "./Onward.tsx";
import { watchAgain } from "../../model/run/watch-again.ts";

/** From 100 s on, times are displayed with minutes, as on the clock of the run. */
const CLOCK_FROM_TICKS = 6000;

/** A robot that drives in reverse can reach the goal too. */
const BOTH_SIDES = [-1, 1] as const;

/** The driver, the pose of the robot, and the figures of the run. */
export interface Solved {
  ticks: number;
  bumps: number;
  driver: DriverName;
  pose: Pose;
}

/** The parts of the card that the race adds. */
export interface SolvedRace {
  /** the result of the race, if there is one */
  raceOutcome: ReactNode;
  /** the button that races this run */
  raceButton: ReactNode;
}

interface SolvedCardProps extends SolvedRace {
  view: StageViewStore;
  solved: Solved;
  onClose: () => void;
}

export function SolvedCard({ view, solved, raceOutcome, raceButton, onClose }: SolvedCardProps) {
  const { t, i18n } = useTranslation(["words", "missions"], { useSuspense: false });
  const { simulator, workspace, challenge, screen } = useServices();
  const { ticks, bumps, driver, pose } = solved;
  // Time in which a script made its robot wait is displayed separately.
  const waited = useWaited(ticks);
  const timeText = (time: number) =>
    time < CLOCK_FROM_TICKS
      ? t("words:cards.solved.seconds", { seconds: formatSeconds(time, i18n.language) })
      : formatClock(time, i18n.language);
  const maze = useStore(workspace, (state) => state.maze);
  const lines = useStore(workspace, (state) => countLines(state.program.rules));
  const allowed = useStore(challenge, (state) => openTask(state)?.allowed.lines ?? null);
  // In a task with several mazes, one solved maze is only a part of the solution.
  const mazes = useStore(challenge, (state) => mazeCount(openTask(state)));
  const isByHand = useStore(
    challenge,
    ({ result }) => result.state === "here" && result.driver !== "program",
  );
  const isShareShown = useTool("share");
  const isPart = useStore(challenge, ({ result }) => result.state === "here") && mazes > 1;
  // A check of the same program has already named the mazes in which it fails.
  const isChecked = useStore(challenge, ({ checked }) => checked !== null);
  const isMetInAll =
    useStore(challenge, ({ result }) => result.state === "met" && result.driver === "program") &&
    mazes > 1;
  // The clock displays the run in one of the mazes.
  const ofTime = isMetInAll ? "words:cards.solved.longestTime" : "words:cards.solved.time";
  const keepClear = useMemo(() => maze.goals, [maze]);
  // A challenge that allows no lines has no lines to count.
  const hasLines = driver === "program" && allowed !== 0;
  return (
    <FloatingCard
      view={view}
      pose={pose}
      keepClear={keepClear}
      trailSides={BOTH_SIDES}
      tone="good"
      icon={<Icon of={Flag} size={18} />}
      title={
        !isPart
          ? t("words:cards.solved.title")
          : isChecked || isByHand
            ? t("missions:bar.hereOnly")
            : t("missions:bar.here", allOf(mazes, i18n.language))
      }
      onClose={onClose}
    >
      <p className={styles["sentence"]}>
        <SolvedSentence driver={driver} lines={lines} at={ticks} />
      </p>
      <dl className={styles["figures"]}>
        <div>
          <dt>{t(waited > 0 ? "words:cards.solved.driving" : ofTime)}</dt>
          <dd>{timeText(ticks - waited)}</dd>
        </div>
        {waited > 0 && (
          <div>
            <dt>{t("words:cards.solved.waiting")}</dt>
            <dd>{timeText(waited)}</dd>
          </div>
        )}
        {hasLines && (
          <div>
            <dt>
              {t("words:cards.solved.lines", { count: lines })}
              {allowed !== null && (
                <small>{t("words:cards.solved.allowed", { count: allowed })}</small>
              )}
            </dt>
            <dd>{lines}</dd>
          </div>
        )}
        <div>
          <dt>{t("words:cards.solved.bumps", { count: bumps })}</dt>
          <dd>{bumps}</dd>
        </div>
      </dl>
      {raceOutcome}
      <div className={styles["actions"]}>
        <Onward maze={maze} onClose={onClose} />
        {isShareShown && (
          <Button icon={<Icon of={Share} />} onClick={() => screen.setState({ isSharing: true })}>
            {t("words:cards.solved.share")}
          </Button>
        )}
        <Button kind="quiet" icon={<Icon of={History} />} onClick={() => watchAgain(simulator, 0)}>
          {t("words:cards.watchAgain")}
        </Button>
        {raceButton}
      </div>
    </FloatingCard>
  );
}

interface SolvedSentenceProps {
  driver: DriverName;
  lines: number;
  /** the tick at which it was solved */
  at: number;
}

/** Describes what was solved, which depends on the challenge and the driver. */
function SolvedSentence({ driver, lines, at }: SolvedSentenceProps) {
  const { t } = useTranslation();
  const { challenge: store, run } = useServices();
  const task = useStore(store, openTask);
  const isMet = useStore(store, (state) => state.result.state === "met");
  const goal = task?.goal;
  // The robot may have driven on since.
  const reading = useStore(run, ({ snapshot }) =>
    goal?.kind === "stop" && snapshot?.tick === at
      ? Math.round(snapshot.sensors[goal.sensor])
      : null,
  );
  if (reading !== null) return t("cards.solved.stopped", { reading });
  if (task !== null && task.goal.kind !== "reach") return t("cards.solved.challenge");
  const mazes = task?.mazes.length ?? 1;
  if (isMet && mazes > 1 && driver === "program") {
    return t("cards.solved.mazes", { passed: mazes });
  }
  if (driver !== "program") return t(`cards.solved.${driver}`);
  return lines === 0
    ? t("cards.solved.otherwiseOnly")
    : t("cards.solved.program", { count: lines });
}
