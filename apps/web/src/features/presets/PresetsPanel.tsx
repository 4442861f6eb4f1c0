/** Preset mazes, the daily maze, random mazes, and algorithms to choose from. */
import { mazePresets } from "@corridor/maze";
import { useId, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { DailyMaze } from "./DailyMaze.tsx";
import { useRights } from "../../model/use-rights.ts";
import { chooseMaze } from "../../model/presets/choose-preset.ts";
import { MazePicture } from "../../ui/MazePicture.tsx";
import { presetOf } from "../../model/presets/preset-of.ts";
import { ChoiceCard } from "../../ui/ChoiceCard.tsx";
import { RandomMaze } from "./RandomMaze.tsx";
import styles from "./presets.module.css";

export interface PresetsPanelProps {
  /** the preset algorithms, in the same layout as the mazes */
  algorithms: (onChosen: (() => void) | undefined) => ReactNode;
  /** called after a choice, so that a dialog can close */
  onChosen?: () => void;
}

export function PresetsPanel({ algorithms, onChosen }: PresetsPanelProps) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const rights = useRights();
  const randomId = useId();
  const algorithmsId = useId();
  const opened = useStore(services.workspace, (state) => presetOf(state.maze));
  const solved = useStore(services.solved, (state) => state.ids);
  return (
    <div className={styles["presets"]}>
      <ul className={styles["grid"]} aria-label={t("presets.presets")}>
        {mazePresets.map(({ id, maze }) => (
          <ChoiceCard
            key={id}
            title={t(`presets.${id}.title`)}
            hint={t(`presets.${id}.hint`)}
            picture={<MazePicture maze={maze} />}
            isOpen={id === opened}
            isSolved={solved.includes(id)}
            onChoose={() => {
              chooseMaze(services, i18n, { ...maze, name: t(`presets.${id}.title`) });
              onChosen?.();
            }}
          />
        ))}
      </ul>
      <p className={styles["note"]}>{t("presets.note")}</p>
      <div className={styles["section"]}>
        <DailyMaze
          onUse={(maze) => {
            chooseMaze(services, i18n, maze);
            onChosen?.();
          }}
        />
      </div>
      <section className={styles["section"]} aria-labelledby={randomId}>
        <h2 id={randomId} className={styles["heading"]}>
          {t("presets.random.title")}
        </h2>
        <RandomMaze
          onUse={(maze) => {
            chooseMaze(services, i18n, maze);
            onChosen?.();
          }}
        />
      </section>
      {rights === null && (
        <section className={styles["section"]} aria-labelledby={algorithmsId}>
          <h2 id={algorithmsId} className={styles["heading"]}>
            {t("presets.algorithms")}
          </h2>
          <details>
            <summary className={styles["summary"]}>{t("program.algorithms")}</summary>
            {algorithms(onChosen)}
          </details>
        </section>
      )}
    </div>
  );
}
