/** Current state of the open project, and the best result on this device. Announces each change. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useAnnouncement } from "../../model/use-announcement.ts";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import styles from "./lessons.module.css";
import type { ProjectId } from "../../model/lessons/missions/projects.ts";
import { bestText, isReached, statusText } from "./project-text.ts";

interface ProjectOutcomeProps {
  project: ProjectId;
  service: LessonsService;
}

export function ProjectOutcome({ project, service }: ProjectOutcomeProps) {
  const words = useTranslation(["missions", "words"], { useSuspense: false });
  const status = useStore(service.project.status, (state) => state.status);
  const best = useStore(service.progress, (state) => state.best[project]);
  const text = statusText(words, status);
  useAnnouncement(status.kind === "checking" ? null : text, "mission");
  return (
    <>
      <p role="note" className={styles["outcome"]} data-state={isReached(status) ? "met" : "open"}>
        {text}
      </p>
      {best !== undefined && <p className={styles["best"]}>{bestText(words, project, best)}</p>}
    </>
  );
}
