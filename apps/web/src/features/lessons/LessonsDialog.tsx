/** The path of missions. All missions are open at once, with progress and the current position. */
import { Check, Circle, CircleDot } from "lucide";
import { useEffect, useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import type { LessonsRecord } from "../../model/lessons/lessons-storage.ts";
import styles from "./lessons-dialog.module.css";
import { Finish } from "./Finish.tsx";
import { bestText } from "./bonus-text.ts";
import { bonusMissionIdeas, bonusMissions } from "../../model/lessons/missions/bonus-missions.ts";
import { MissionPicture } from "./MissionPicture.tsx";
import { chapterIds, chapters, type ChapterId } from "../../model/lessons/missions/chapters.ts";
import { ideas } from "../../model/lessons/missions/ideas.ts";
import { missionIds } from "../../model/lessons/missions/mission.ts";
import { missions } from "../../model/lessons/missions/missions.ts";

export interface LessonsDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/** Opens once the lessons and their texts are loaded. */
export function LessonsDialog({ isOpen, onClose }: LessonsDialogProps) {
  const { t, ready } = useTranslation("missions", { useSuspense: false });
  const { lessons } = useServices();
  const [service, setService] = useState<LessonsService | null>(null);
  useEffect(() => {
    if (isOpen && service === null) void lessons.load().then(setService, onClose);
  }, [isOpen, service, lessons, onClose]);
  useEffect(() => {
    if (isOpen) service?.progress.refresh();
  }, [isOpen, service]);
  return (
    <Dialog
      isOpen={isOpen && ready && service !== null}
      onClose={onClose}
      title={t("path.title")}
      subtitle={t("path.subtitle")}
      footer={
        // Always in sight: the list of missions scrolls above it.
        <nav className={styles["otherPages"]} aria-label={t("path.more")}>
          <a className={styles["otherPage"]} href="/join">
            {t("path.join")}
          </a>
          <a className={styles["otherPage"]} href="/teach">
            {t("path.teachers")}
          </a>
        </nav>
      }
    >
      {service !== null && <MissionPath service={service} onClose={onClose} />}
    </Dialog>
  );
}

function MissionPath({ service, onClose }: { service: LessonsService; onClose: () => void }) {
  const { t } = useTranslation("missions");
  const { lessons, challenge } = useServices();
  const done = useStore(service.progress.results, (state) => state.done);
  const best = useStore(service.progress.results, (state) => state.best);
  const open = useStore(challenge, (state) => state.mission);
  const isInChallenge = useStore(challenge, (state) => state.lesson !== null);
  const openMission = (id: string): void => {
    onClose();
    void lessons.openMission(id);
  };
  const count = missions.filter(({ id }) => done[id] !== undefined).length;
  return (
    <>
      {count === missions.length && <Finish service={service} done={done} />}
      {chapterIds.map((chapter) => (
        <Chapter key={chapter} chapter={chapter} done={done} open={open} onOpen={openMission} />
      ))}
      <BonusMissions best={best} open={open} onOpen={openMission} />
      <div className={styles["pathFoot"]}>
        <p className={styles["count"]}>{t("path.progress", { count, all: missions.length })}</p>
        {isInChallenge && (
          <Button
            size="small"
            onClick={() => {
              onClose();
              service.navigation.goHome();
            }}
          >
            {t("path.own")}
          </Button>
        )}
        <Button
          kind="quiet"
          size="small"
          disabled={count === 0 && Object.keys(best).length === 0}
          onClick={() => service.progress.delete()}
        >
          {t("path.reset")}
        </Button>
      </div>
    </>
  );
}

interface ChapterProps {
  chapter: ChapterId;
  done: LessonsRecord["done"];
  /** id of the open mission */
  open: string | null;
  onOpen: (id: string) => void;
}

function Chapter({ chapter, done, open, onOpen }: ChapterProps) {
  const { t } = useTranslation("missions");
  const titleId = useId();
  const ids = chapters[chapter];
  const first = missionIds.findIndex((id) => id === ids[0]);
  const count = ids.filter((id) => done[id] !== undefined).length;
  return (
    <section className={styles["chapter"]} aria-labelledby={titleId}>
      <div className={styles["chapterHead"]}>
        <h3 id={titleId} className={styles["chapterName"]}>
          {t(`chapters.${chapter}`)}
        </h3>
        <p className={styles["count"]}>{t("path.progress", { count, all: ids.length })}</p>
      </div>
      <ol className={styles["path"]} start={first + 1}>
        {ids.map((id, at) => {
          const state = done[id] !== undefined ? "done" : open === id ? "current" : "open";
          const mazes = missions[first + at]?.challenge.mazes ?? [];
          return (
            <li key={id} className={styles["step"]}>
              <button
                type="button"
                className={styles["mission"]}
                aria-current={open === id ? "step" : undefined}
                onClick={() => onOpen(id)}
              >
                <span className={styles["picture"]}>
                  <MissionPicture mazes={mazes} ideas={ideas[id]} />
                </span>
                <span className={styles["missionName"]}>
                  {t("path.name", { number: first + at + 1, name: t(`missions.${id}.name`) })}
                </span>
                <span className={styles["state"]} data-state={state}>
                  <StateIcon state={state} />
                  {t(`path.${state}`)}
                </span>
              </button>
            </li>
          );
        })}
      </ol>
    </section>
  );
}

interface BonusMissionsProps {
  best: LessonsRecord["best"];
  /** id of the open bonus mission */
  open: string | null;
  onOpen: (id: string) => void;
}

function BonusMissions({ best, open, onOpen }: BonusMissionsProps) {
  const words = useTranslation(["missions", "words"], { useSuspense: false });
  const { t } = words;
  const titleId = useId();
  return (
    <section className={styles["chapter"]} aria-labelledby={titleId}>
      <div className={styles["chapterHead"]}>
        <h3 id={titleId} className={styles["chapterName"]}>
          {t("missions:bonus.all")}
        </h3>
        <p className={styles["count"]}>{t("missions:bonus.note")}</p>
      </div>
      <ol className={styles["path"]}>
        {bonusMissions.map(({ id, challenge: { mazes } }) => {
          const result = best[id];
          const state = result !== undefined ? "done" : open === id ? "current" : "open";
          return (
            <li key={id} className={styles["step"]}>
              <button
                type="button"
                className={styles["mission"]}
                aria-current={open === id ? "step" : undefined}
                onClick={() => onOpen(id)}
              >
                <span className={styles["picture"]}>
                  <MissionPicture mazes={mazes} ideas={bonusMissionIdeas[id]} />
                </span>
                <span className={styles["missionName"]}>
                  {t(`missions:bonusMissions.${id}.name`)}
                </span>
                <span className={styles["state"]} data-state={state}>
                  <StateIcon state={state} />
                  {result === undefined ? t(`missions:path.${state}`) : bestText(words, id, result)}
                </span>
              </button>
            </li>
          );
        })}
      </ol>
    </section>
  );
}

function StateIcon({ state }: { state: "done" | "current" | "open" }) {
  const icon = { done: Check, current: CircleDot, open: Circle }[state];
  return <Icon of={icon} size={14} />;
}
