/** The projects on this device, newest first, with buttons to open and delete each. */
import { sizeOf } from "@corridor/maze";
import { Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import type { Project } from "../../app/project-storage.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { MazePicture } from "../presets/MazePicture.tsx";
import styles from "./maze-menu.module.css";

interface WorksListProps {
  works: readonly Project[];
  onOpen: (work: Project) => void;
  onDelete: (work: Project) => void;
}

export function WorksList({ works, onOpen, onDelete }: WorksListProps) {
  const { t, i18n } = useTranslation();
  const currentId = useServices().projects.currentId();
  const when = new Intl.DateTimeFormat(i18n.language, {
    dateStyle: "medium",
    timeStyle: "short",
    numberingSystem: "latn",
  });
  return (
    <section className={styles["works"]} aria-labelledby="works-heading">
      <h2 id="works-heading" className={styles["heading"]}>
        {t("works.onThisDevice")}
      </h2>
      {works.length === 0 && <p className={styles["note"]}>{t("works.empty")}</p>}
      <ul className={styles["list"]}>
        {works.map((work) => {
          const name = work.maze.name === "" ? t("works.unnamed") : work.maze.name;
          const isOpen = work.id === currentId;
          return (
            <li key={work.id} className={styles["row"]}>
              <button
                type="button"
                className={styles["work"]}
                aria-label={t("works.open", { name })}
                aria-current={isOpen}
                disabled={isOpen}
                onClick={() => onOpen(work)}
              >
                <span className={styles["thumbnail"]}>
                  <MazePicture maze={work.maze} />
                </span>
                <span className={styles["words"]}>
                  <span className={styles["workName"]}>{name}</span>
                  <span className={styles["note"]}>
                    {isOpen
                      ? t("works.isOpen")
                      : t("works.openNote", {
                          ...sizeOf(work.maze),
                          when: when.format(work.savedAt),
                        })}
                  </span>
                </span>
              </button>
              {!isOpen && (
                <IconButton label={t("works.delete", { name })} onClick={() => onDelete(work)}>
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
