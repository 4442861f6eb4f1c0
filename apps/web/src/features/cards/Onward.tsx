/**
 * The next step after a solved maze: the check, the next task or mission, the dialog of all missions, or
 * the next preset.
 */
import { mazePresets, type MazeDocument } from "@corridor/maze";
import { ArrowRight, ImageDown, ListChecks } from "lucide";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { mazeCount, nextMazeToDrive, openTask } from "../../model/challenge/challenge-store.ts";
import { nextTaskOf } from "../../model/lessons/task-order.ts";
import { useServices } from "../../model/use-services.ts";
import { allOf } from "../../text/all-of.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import { missionIds, nextMission } from "../../model/lessons/missions/mission.ts";
import { chooseMaze } from "../../model/presets/choose-preset.ts";
import styles from "./cards.module.css";

interface OnwardProps {
  maze: MazeDocument;
  onClose: () => void;
}

export function Onward({ maze, onClose }: OnwardProps) {
  const { challenge } = useServices();
  const isChallenge = useStore(challenge, (state) => state.lesson !== null);
  return isChallenge ? (
    <AfterChallenge onClose={onClose} />
  ) : (
    <AfterMaze maze={maze} onClose={onClose} />
  );
}

function AfterChallenge({ onClose }: Pick<OnwardProps, "onClose">) {
  const { t, i18n } = useTranslation(["words", "missions"], { useSuspense: false });
  const { challenge, lessons } = useServices();
  const count = useStore(challenge, (state) => mazeCount(openTask(state)));
  const isCheckable = useStore(
    challenge,
    ({ result }) => result.state === "here" && result.driver === "program",
  );
  const nextMaze = useStore(challenge, nextMazeToDrive);
  const nextTask = useStore(challenge, nextTaskOf);
  const mission = useStore(challenge, (state) => state.mission);
  const state = useStore(challenge, (each) => each.result.state);
  const isChecking = useStore(challenge, (each) => each.isChecking);
  const [service, setService] = useState<LessonsService | null>(null);
  useEffect(() => {
    challenge.setState({ hasCard: true });
    return () => challenge.setState({ hasCard: false });
  }, [challenge]);
  useEffect(() => {
    void lessons.load().then(setService, () => undefined);
  }, [lessons]);
  if (service === null) return null;
  if (isCheckable && count > 1) {
    return (
      <Button
        kind="primary"
        disabled={isChecking}
        icon={<Icon of={ListChecks} />}
        onClick={() => {
          onClose();
          void service.attempt.check();
        }}
      >
        {t("missions:card.check", allOf(count, i18n.language))}
      </Button>
    );
  }
  if (nextMaze !== null) {
    return (
      <Button kind="primary" onClick={() => service.navigation.showMaze(nextMaze)}>
        {t("missions:card.maze", { number: nextMaze + 1 })}
        <Icon of={ArrowRight} className={styles["onward"]} />
      </Button>
    );
  }
  if (state === "met" && nextTask !== null) {
    return (
      <Button kind="primary" onClick={() => service.navigation.openTask(nextTask)}>
        {t("missions:lesson.next")}
        <Icon of={ArrowRight} className={styles["onward"]} />
      </Button>
    );
  }
  if (state !== "met" || mission === null) return null;
  const next = nextMission(mission);
  return (
    <>
      {next !== null && (
        <Button kind="primary" onClick={() => void lessons.openMission(next)}>
          {t("words:cards.solved.nextMission")}
          <Icon of={ArrowRight} className={styles["onward"]} />
        </Button>
      )}
      <FinishButton service={service} mission={mission} />
    </>
  );
}

/** All missions are done: opens the dialog of all missions, which starts with a picture to save. */
function FinishButton({ service, mission }: { service: LessonsService; mission: string }) {
  const { t } = useTranslation("missions", { useSuspense: false });
  const { challenge } = useServices();
  const isAllDone = useStore(service.progress.results, ({ done }) =>
    missionIds.every((id) => done[id] !== undefined),
  );
  // A bonus mission has a result of its own.
  if (!isAllDone || !missionIds.some((id) => id === mission)) return null;
  return (
    <Button
      kind={nextMission(mission) === null ? "primary" : "outline"}
      icon={<Icon of={ImageDown} />}
      onClick={() => challenge.setState({ isPathOpen: true })}
    >
      {t("finish.save")}
    </Button>
  );
}

function AfterMaze({ maze, onClose }: OnwardProps) {
  const { t, i18n } = useTranslation();
  const services = useServices();
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
