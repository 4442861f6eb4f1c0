/** The path of missions: all of them open at once, with what is done and where the reader is. */
import { Check, Circle, CircleDot } from "lucide-react";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { MazePicture } from "../presets/MazePicture.tsx";
import type { LessonsService } from "./lessons-service.ts";
import styles from "./lessons.module.css";
import { missions } from "./missions/missions.ts";

export interface LessonsDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/** Opens once the lessons and their words are there. */
export function LessonsDialog({ isOpen, onClose }: LessonsDialogProps) {
  const { t, ready } = useTranslation("missions", { useSuspense: false });
  const { lessons } = useServices();
  const [service, setService] = useState<LessonsService | null>(null);
  useEffect(() => {
    if (isOpen && service === null) void lessons.load().then(setService, onClose);
  }, [isOpen, service, lessons, onClose]);
  useEffect(() => {
    if (isOpen) service?.showProgress();
  }, [isOpen, service]);
  return (
    <Dialog
      isOpen={isOpen && ready && service !== null}
      onClose={onClose}
      title={t("path.title")}
      subtitle={t("path.subtitle")}
    >
      {service !== null && <MissionPath service={service} onClose={onClose} />}
    </Dialog>
  );
}

function MissionPath({ service, onClose }: { service: LessonsService; onClose: () => void }) {
  const { t } = useTranslation("missions");
  const { lessons, challenge } = useServices();
  const done = useStore(service.progress, (state) => state.done);
  const open = useStore(challenge, (state) => state.mission);
  const isInChallenge = useStore(challenge, (state) => state.challenge !== null);
  const count = missions.filter(({ id }) => done[id] !== undefined).length;
  return (
    <>
      <ol className={styles["path"]}>
        {missions.map(({ id, challenge: { mazes } }, at) => {
          const state = done[id] !== undefined ? "done" : open === id ? "current" : "open";
          return (
            <li key={id} className={styles["step"]}>
              <button
                type="button"
                className={styles["mission"]}
                aria-current={open === id ? "step" : undefined}
                onClick={() => {
                  onClose();
                  void lessons.openMission(id);
                }}
              >
                <span className={styles["picture"]}>
                  {mazes[0] !== undefined && <MazePicture maze={mazes[0]} />}
                </span>
                <span className={styles["missionName"]}>
                  {t("path.name", { number: at + 1, name: t(`missions.${id}.name`) })}
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
      <div className={styles["pathFoot"]}>
        <p className={styles["count"]}>{t("path.progress", { count, all: missions.length })}</p>
        {isInChallenge && (
          <Button
            size="small"
            onClick={() => {
              onClose();
              service.goHome();
            }}
          >
            {t("path.own")}
          </Button>
        )}
        <Button
          kind="quiet"
          size="small"
          disabled={count === 0}
          onClick={() => service.forgetProgress()}
        >
          {t("path.reset")}
        </Button>
      </div>
    </>
  );
}

function StateIcon({ state }: { state: "done" | "current" | "open" }) {
  const Icon = { done: Check, current: CircleDot, open: Circle }[state];
  return <Icon size={14} aria-hidden="true" />;
}
