/** Why the program bumped: which line, the room that it needed, the room that it had, and the mends. */
import { applyMend, storyOfBump, type Mend } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { DELAY_DISTANCE } from "@corridor/simulation";
import { History, Play } from "lucide-react";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { Explanation } from "../../stores/card-store.ts";
import { Badge } from "../../ui/Badge.tsx";
import { Button } from "../../ui/Button.tsx";
import { useRights } from "../lessons/use-rights.ts";
import { conditionText } from "../program/condition-text.ts";
import { allowsMend } from "../program/mend-rights.ts";
import { takeMend } from "../program/take-mend.ts";
import type { StageViewStore } from "../stage/stage-view.ts";
import { BurstIcon } from "../timeline/BurstIcon.tsx";
import { bumpReason, bumpTitle } from "./bump-sentence.ts";
import styles from "./cards.module.css";
import { FloatingCard } from "./FloatingCard.tsx";
import { hitBlock } from "./hit-block.ts";
import { mendText } from "./mend-text.ts";
import { RoomBars } from "./RoomBars.tsx";
import { runFromStart, tellMended } from "./run-from-start.ts";
import { watchAgain } from "./watch-again.ts";

/** Four seconds, or what led to the bump where that began earlier. */
const WATCHED_TICKS = 240;

interface BumpCardProps {
  view: StageViewStore;
  explanation: Explanation;
  onClose: () => void;
}

export function BumpCard({ view, explanation, onClose }: BumpCardProps) {
  const { t, i18n } = useTranslation();
  const { workspace, simulator, screen, run } = useServices();
  const rights = useRights();
  const { moment, program, mends } = explanation;
  // A program that was edited since needs other mends, or none.
  const isSame = useStore(workspace, (state) => state.program === program);
  const offered = isSame
    ? mends.filter((each) => allowsMend(each, program.rules.length, rights))
    : [];
  const { cause, pose, line, tick } = moment;
  const goals = useStore(workspace, (state) => state.maze.goals);
  const keepClear = useMemo(
    () => [...(cause === null ? [] : [hitBlock(pose, cause.side)]), ...goals],
    [cause, pose, goals],
  );
  if (cause === null) return null;
  const story = storyOfBump(cause);
  const isNumbered = typeof line === "number";
  const badge = isNumbered ? line + 1 : 0;

  function mend(chosen: Mend) {
    takeMend(workspace, chosen, applyMend(program, chosen));
    tellMended({ screen, run, simulator, words: i18n });
    onClose();
  }

  return (
    <FloatingCard
      view={view}
      pose={pose}
      keepClear={keepClear}
      tone="bad"
      icon={<BurstIcon size={18} />}
      title={bumpTitle(t, line)}
      onClose={onClose}
    >
      <p className={styles["sentence"]}>
        {isNumbered && <Badge tone="bad">{badge}</Badge>}
        <span>{bumpReason(t, story, program, line)}</span>
      </p>
      <EarlierTurn program={program} mend={offered[0]} bumped={line} />
      {story.needs !== null && (
        <RoomBars
          needsLabel={
            isNumbered ? t("cards.bump.needsLine", { line: badge }) : t("cards.bump.needsOtherwise")
          }
          freeLabel={t(story.side === "front" ? "cards.bump.freeFront" : "cards.bump.freeBack")}
          needs={story.needs}
          free={story.free}
        />
      )}
      <div className={styles["actions"]}>
        {offered.map((each, at) => (
          <Button
            key={JSON.stringify(each)}
            kind={at === 0 ? "primary" : "outline"}
            onClick={() => mend(each)}
          >
            {mendText(t, program, each)}
          </Button>
        ))}
        {!isSame && (
          <Button
            kind="primary"
            icon={<Play aria-hidden="true" fill="currentColor" />}
            onClick={() => runFromStart(simulator)}
          >
            {t("cards.fromStart")}
          </Button>
        )}
        <Button
          icon={<History aria-hidden="true" />}
          onClick={() => watchAgain(simulator, Math.min(cause.decidedAt, tick - WATCHED_TICKS))}
        >
          {t("cards.watchAgain")}
        </Button>
      </div>
    </FloatingCard>
  );
}

/** The line that turned too early, where that is what led another one into the wall. */
function EarlierTurn(props: {
  program: ProgramDocument;
  mend: Mend | undefined;
  bumped: LineRef | null;
}) {
  const { program, mend, bumped } = props;
  const { t, i18n } = useTranslation();
  if (mend?.kind !== "action" || mend.line === bumped) return null;
  const when = program.rules[mend.line]?.when ?? null;
  if (when === null) return null;
  return (
    <p className={styles["sentence"]}>
      <Badge>{mend.line + 1}</Badge>
      <span>
        {t("program.advice.intoOpening", {
          condition: conditionText(t, when, i18n.language),
          drivesOn: DELAY_DISTANCE,
        })}
      </span>
    </p>
  );
}
