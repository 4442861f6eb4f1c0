/**
 * Explains a bump: what happened, the line that caused it and, in free play or where a task gives
 * them, tested fixes.
 */
import { applyFix, causeLine, type Fix } from "@corridor/coach";
import { History, Play } from "lucide";
import { useMemo, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useHelp } from "../../model/use-rights.ts";
import { useServices } from "../../model/use-services.ts";
import { useWaited } from "../../model/use-waited.ts";
import type { Explanation } from "../../model/run/card-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Badge } from "../../ui/Badge.tsx";
import { Button } from "../../ui/Button.tsx";
import { focusLine } from "../../model/workspace/focus-line.ts";
import { setFixedProgram } from "../../model/workspace/set-fixed-program.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { BurstIcon } from "../../ui/BurstIcon.tsx";
import styles from "./cards.module.css";
import {
  diagnosisText,
  diagnosisTitle,
  diagnosisWords,
  roomText,
  statesOtherRoom,
} from "../../model/diagnosis/diagnosis-text.ts";
import { FloatingCard } from "./FloatingCard.tsx";
import { fixText } from "./fix-text.ts";
import { RoomBars } from "./RoomBars.tsx";
import { runFromStart, showFixed } from "./run-from-start.ts";
import { trailSide } from "./trail-end.ts";
import { watchAgain } from "../../model/run/watch-again.ts";

/**
 * Watch again starts at least 240 ticks (4 s) before the bump, or earlier if the cause is earlier.
 */
const WATCHED_TICKS = 240;

interface BumpCardProps {
  view: StageViewStore;
  explanation: Explanation;
  task: ReactNode;
  onClose: () => void;
}

export function BumpCard({ view, explanation, task, onClose }: BumpCardProps) {
  const { t, i18n, ready } = useTranslation(["diagnosis", "words"], { useSuspense: false });
  const { workspace, simulator, screen, run, timeline, challenge } = useServices();
  const { event: moment, program, diagnosis } = explanation;
  // The fixes are not valid for a program that was edited since.
  const isSame = useStore(workspace, (state) => state.program === program);
  // In a challenge, the card names the line and the idea, and the student finds the change.
  const isChallenge = useStore(challenge, (state) => state.lesson !== null);
  const hasFixes = useHelp("fixes");
  const { pose, tick } = moment;
  // The timeline arrives after the bump; the card renders again with its waiting times.
  useWaited(tick);
  const goals = useStore(workspace, (state) => state.maze.goals);
  const keepClear = useMemo(() => {
    const event = diagnosis?.event;
    return [...(event?.kind === "bump" ? [event.contact.cell] : []), ...goals];
  }, [diagnosis, goals]);
  const trailSides = useMemo(() => {
    const event = diagnosis?.event;
    return event?.kind === "bump" ? [trailSide(pose, event.contact)] : [];
  }, [diagnosis, pose]);
  const line = diagnosis === null ? null : causeLine(diagnosis);
  const lineId = useStore(workspace, (state) =>
    typeof line === "number" ? state.lineIds[line] : undefined,
  );
  if (diagnosis === null || diagnosis.event.kind !== "bump" || !ready) return null;
  const { event, cause, fixes } = diagnosis;
  const words = diagnosisWords(t, i18n.language, (at) => timeline.waitedUpTo(at));
  const offered = isSame && hasFixes ? fixes : [];
  // The bars show the room of the line that drove. Beside a sentence about another line, or about the
  // room at another moment, they would be misread as the room of that line or moment.
  const isAboutDriver = cause === null || (line === event.line && !statesOtherRoom(event, cause));
  const since = cause === null ? event.startedAt : Math.min(event.startedAt, cause.moment.tick);

  function take(chosen: Fix) {
    setFixedProgram(workspace, chosen, applyFix(program, chosen));
    showFixed({ screen, run, workspace, simulator, words: i18n });
    onClose();
  }

  return (
    <FloatingCard
      view={view}
      pose={pose}
      keepClear={keepClear}
      trailSides={trailSides}
      tone="bad"
      icon={<BurstIcon size={18} />}
      title={diagnosisTitle(words, diagnosis)}
      task={task}
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
          text={roomText(words, event, cause)}
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
            icon={<Icon of={Play} fill="currentColor" />}
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
          icon={<Icon of={History} />}
          onClick={() => watchAgain(simulator, Math.min(since, tick - WATCHED_TICKS))}
        >
          {t("words:cards.watchAgain")}
        </Button>
      </div>
    </FloatingCard>
  );
}
