/** The goal is reached: what it took, and what to do next. Factual; the robot celebrates. */
import { mazePresets, type MazeDocument } from "@corridor/maze";
import { ArrowRight, Flag, History, Share } from "lucide-react";
import { useEffect, useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { Explanation } from "../../stores/card-store.ts";
import { formatClock, formatSeconds } from "../../text/numbers.ts";
import { Button } from "../../ui/Button.tsx";
import { chooseMaze } from "../presets/choose-preset.ts";
import { ShareDialog } from "../share/lazy-share-dialog.ts";
import type { StageViewStore } from "../stage/stage-view.ts";
import styles from "./cards.module.css";
import { FloatingCard } from "./FloatingCard.tsx";
import { watchAgain } from "./watch-again.ts";

/** From 100 s on minutes are easier to read, as on the clock of the run. */
const CLOCK_FROM_TICKS = 6000;

interface SolvedCardProps {
  view: StageViewStore;
  explanation: Explanation;
  onClose: () => void;
}

export function SolvedCard({ view, explanation, onClose }: SolvedCardProps) {
  const { t, i18n } = useTranslation();
  const { simulator, workspace, challenge } = useServices();
  const { tick, bumps, driver, pose, line } = explanation.moment;
  const maze = useStore(workspace, (state) => state.maze);
  const lines = useStore(workspace, (state) => countLines(state.program.rules));
  const allowed = useStore(challenge, (state) => state.challenge?.allowed.lines ?? null);
  const [isSharing, setSharing] = useState(false);
  const keepClear = useMemo(() => maze.goals, [maze]);
  const isProgram = driver === "program";
  return (
    <FloatingCard
      view={view}
      pose={pose}
      keepClear={keepClear}
      tone="good"
      icon={<Flag size={18} aria-hidden="true" />}
      title={t("cards.solved.title")}
      onClose={onClose}
    >
      <p className={styles["sentence"]}>
        {isProgram
          ? lines === 0 && line === "default"
            ? t("cards.solved.otherwiseOnly")
            : t("cards.solved.program", { count: lines })
          : t(`cards.solved.${driver}`)}
      </p>
      <dl className={styles["figures"]}>
        <div>
          <dt>{t("cards.solved.time")}</dt>
          <dd>
            {tick < CLOCK_FROM_TICKS
              ? t("cards.solved.seconds", { seconds: formatSeconds(tick, i18n.language) })
              : formatClock(tick, i18n.language)}
          </dd>
        </div>
        {isProgram && (
          <div>
            <dt>
              {t("cards.solved.lines")}
              {allowed !== null && <small>{t("cards.solved.allowed", { count: allowed })}</small>}
            </dt>
            <dd>{lines}</dd>
          </div>
        )}
        <div>
          <dt>{t("cards.solved.bumps")}</dt>
          <dd>{bumps}</dd>
        </div>
      </dl>
      <div className={styles["actions"]}>
        <Onward maze={maze} onClose={onClose} />
        <Button icon={<Share aria-hidden="true" />} onClick={() => setSharing(true)}>
          {t("cards.solved.share")}
        </Button>
        <Button
          kind="quiet"
          icon={<History aria-hidden="true" />}
          onClick={() => watchAgain(simulator, 0)}
        >
          {t("cards.watchAgain")}
        </Button>
      </div>
      <ShareDialog isOpen={isSharing} onClose={() => setSharing(false)} />
    </FloatingCard>
  );
}

/** The next mission after a mission, the next ready-made maze after one of them; nothing after others. */
function Onward({ maze, onClose }: { maze: MazeDocument; onClose: () => void }) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const { challenge, lessons } = services;
  const isChallenge = useStore(challenge, (state) => state.challenge !== null);
  const isMet = useStore(challenge, (state) => state.result.state === "met");
  const [mission, setMission] = useState<string | null>(null);
  useEffect(() => {
    if (!isChallenge) return;
    void lessons.load().then(
      (service) => setMission(service.nextMission()),
      () => setMission(null),
    );
  }, [isChallenge, lessons]);
  if (isChallenge) {
    if (mission === null || !isMet) return null;
    return (
      <Button kind="primary" onClick={() => void lessons.openMission(mission)}>
        {t("cards.solved.nextMission")}
        <ArrowRight className={styles["onward"]} aria-hidden="true" />
      </Button>
    );
  }
  const at = mazePresets.findIndex((preset) => preset.maze.blocks.join() === maze.blocks.join());
  const next = at < 0 ? undefined : mazePresets[at + 1];
  if (next === undefined) return null;
  const name = t(`presets.${next.id}.title`);
  return (
    <Button
      kind="primary"
      onClick={() => {
        onClose();
        chooseMaze(services, i18n, { ...next.maze, name });
      }}
    >
      {t("cards.solved.nextMaze", { name })}
    </Button>
  );
}

/** Lines that do something. */
function countLines(rules: readonly { when: unknown }[]): number {
  return rules.filter(({ when }) => when !== null).length;
}
