/** The projects on this device, newest first, with buttons to open and delete each. */
import { sizeOf } from "@corridor/maze";
import { Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import type { Project } from "../../model/projects/project-storage.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { MazePicture } from "../../ui/MazePicture.tsx";
import styles from "./maze-menu.module.css";

interface ProjectListProps {
  projects: readonly Project[];
  onOpen: (project: Project) => void;
  onDelete: (project: Project) => void;
}

export function ProjectList({ projects, onOpen, onDelete }: ProjectListProps) {
  const { t, i18n } = useTranslation();
  const currentId = useServices().projects.currentId();
  const when = new Intl.DateTimeFormat(i18n.language, {
    dateStyle: "medium",
    timeStyle: "short",
    numberingSystem: "latn",
  });
  return (
    <section className={styles["projects"]} aria-labelledby="projects-heading">
      <h2 id="projects-heading" className={styles["heading"]}>
        {t("projects.onThisDevice")}
      </h2>
      {projects.length === 0 && <p className={styles["note"]}>{t("projects.empty")}</p>}
      <ul className={styles["list"]}>
        {projects.map((project) => {
          const name = project.maze.name === "" ? t("projects.unnamed") : project.maze.name;
          const isOpen = project.id === currentId;
          return (
            <li key={project.id} className={styles["row"]}>
              <button
                type="button"
                className={styles["project"]}
                aria-label={t("projects.open", { name })}
                aria-current={isOpen}
                disabled={isOpen}
                onClick={() => onOpen(project)}
              >
                <span className={styles["thumbnail"]}>
                  <MazePicture maze={project.maze} />
                </span>
                <span className={styles["words"]}>
                  <span className={styles["projectName"]}>{name}</span>
                  <span className={styles["note"]}>
                    {isOpen
                      ? t("projects.isOpen")
                      : t("projects.openNote", {
                          ...sizeOf(project.maze),
                          when: when.format(project.savedAt),
                        })}
                  </span>
                </span>
              </button>
              {!isOpen && (
                <IconButton
                  label={t("projects.delete", { name })}
                  onClick={() => onDelete(project)}
                >
                  <Icon of={Trash2} />
                </IconButton>
              )}
            </li>
          );
        })}
      </ul>
    </section>
  );
}
