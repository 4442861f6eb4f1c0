/** Why the robot bumped: what happened, the line that caused it and, in free play, changes that were tried. */
import { applyFix, causeLine, type Fix } from "@corridor/coach";
import { History, Play } from "lucide-react";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { useWaited } from "../../app/use-waited.ts";
import type { Explanation } from "../../stores/card-store.ts";
import { Badge } from "../../ui/Badge.tsx";
import { Button } from "../../ui/Button.tsx";
import { focusLine } from "../program/focus-line.ts";
import { takeMend } from "../program/take-mend.ts";
import type { StageViewStore } from "../stage/stage-view.ts";
import { BurstIcon } from "../timeline/BurstIcon.tsx";
import styles from "./cards.module.css";
import { diagnosisText, diagnosisTitle, diagnosisWords } from "./diagnosis-text.ts";
import { FloatingCard } from "./FloatingCard.tsx";
import { fixText } from "./fix-text.ts";
import { RoomBars } from "./RoomBars.tsx";
import { runFromStart, tellMended } from "./run-from-start.ts";
import { trailWay } from "./trail-end.ts";
import { watchAgain } from "./watch-again.ts";

/** Four seconds, or what led to the bump where that began earlier. */
const WATCHED_TICKS = 240;

interface BumpCardProps {
  view: StageViewStore;
  explanation: Explanation;
  onClose: () => void;
}

export function BumpCard({ view, explanation, onClose }: BumpCardProps) {
  const { t, i18n, ready } = useTranslation(["diagnosis", "words"], { useSuspense: false });
  const { workspace, simulator, screen, run, timeline, challenge } = useServices();
  const { event: moment, program, diagnosis } = explanation;
  // A program that was edited since needs other fixes, or none.
  const isSame = useStore(workspace, (state) => state.program === program);
  // In a challenge the student finds the change: the card names the place and the idea.
  const isChallenge = useStore(challenge, (state) => state.challenge !== null);
  const { pose, tick } = moment;
  // The timeline comes later than the bump.
  useWaited(tick);
  const goals = useStore(workspace, (state) => state.maze.goals);
  const keepClear = useMemo(() => {
    const event = diagnosis?.event;
    return [...(event?.kind === "bump" ? [event.contact.cell] : []), ...goals];
  }, [diagnosis, goals]);
  const trailWays = useMemo(() => {
    const event = diagnosis?.event;
    return event?.kind === "bump" ? [trailWay(pose, event.contact)] : [];
  }, [diagnosis, pose]);
  const line = diagnosis === null ? null : causeLine(diagnosis);
  const lineId = useStore(workspace, (state) =>
    typeof line === "number" ? state.lineIds[line] : undefined,
  );
  if (diagnosis === null || diagnosis.event.kind !== "bump" || !ready) return null;
  const { event, cause, fixes } = diagnosis;
  const words = diagnosisWords(t, i18n.language, (at) => timeline.waitedUpTo(at));
  const offered = isSame && !isChallenge ? fixes : [];
  // The room is that of the line that drove: beside a sentence about another one it would be taken for its.
  const isAboutDriver = cause === null || line === event.line;
  const since = cause === null ? event.startedAt : Math.min(event.startedAt, cause.moment.tick);

  function take(chosen: Fix) {
    takeMend(workspace, chosen, applyFix(program, chosen));
    tellMended({ screen, run, simulator, words: i18n });
    onClose();
  }

  return (
    <FloatingCard
      view={view}
      pose={pose}
      keepClear={keepClear}
      trailWays={trailWays}
      tone="bad"
      icon={<BurstIcon size={18} />}
      title={diagnosisTitle(words, diagnosis)}
      onClose={onClose}
    >
      <p className={styles["sentence"]}>
        {typeof line === "number" && <Badge tone="bad">{line + 1}</Badge>}
        <span>{diagnosisText(words, diagnosis)}</span>
      </p>
      {isAboutDriver && event.needs !== null && event.needs > event.reading && (
        <RoomBars
          needsLabel={t("diagnosis:needs")}
          freeLabel={t("diagnosis:had")}
          needs={event.needs}
          free={event.reading}
        />
      )}
      <div className={styles["actions"]}>
        {offered.map((each, at) => (
          <Button
            key={JSON.stringify(each)}
            kind={at === 0 ? "primary" : "outline"}
            onClick={() => take(each)}
          >
            {fixText(t, program, each)}
          </Button>
        ))}
        {!isSame && (
          <Button
            kind="primary"
            icon={<Play aria-hidden="true" fill="currentColor" />}
            onClick={() => runFromStart(simulator)}
          >
            {t("words:cards.fromStart")}
          </Button>
        )}
        {isChallenge && typeof line === "number" && lineId !== undefined && (
          <Button kind="primary" onClick={() => focusLine(lineId)}>
            {t("diagnosis:show", { line: line + 1 })}
          </Button>
        )}
        <Button
          icon={<History aria-hidden="true" />}
          onClick={() => watchAgain(simulator, Math.min(since, tick - WATCHED_TICKS))}
        >
          {t("words:cards.watchAgain")}
        </Button>
      </div>
    </FloatingCard>
  );
}
