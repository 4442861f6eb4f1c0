/** Ready-made mazes to choose from: a picture, a name and a hint each. */
import { mazePresets, type MazePreset } from "@corridor/maze";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { dismiss, tell } from "../../stores/screen-store.ts";
import { setMaze, undo } from "../../stores/workspace-store.ts";
import { MazePicture } from "./MazePicture.tsx";
import styles from "./presets.module.css";

interface PresetsPanelProps {
  /** called once a maze was chosen, so that a dialog can close */
  onChosen?: () => void;
}

export function PresetsPanel({ onChosen }: PresetsPanelProps) {
  const { t } = useTranslation();
  const { workspace, simulator, screen } = useServices();
  const blocks = useStore(workspace, (state) => state.maze.blocks);

  function choose({ id, maze }: MazePreset): void {
    const name = t(`presets.${id}.title`);
    const before = workspace.getState().maze;
    setMaze(workspace, { ...maze, name });
    simulator.send({ type: "reset" });
    const after = workspace.getState().maze;
    const message = tell(screen, {
      tone: "info",
      text: t("presets.chosen", { name }),
      action: {
        label: t("presets.undo"),
        run: () => {
          dismiss(screen, message);
          // Later edits have steps of their own in the history, which stay: the old maze comes on top.
          if (workspace.getState().maze === after) undo(workspace);
          else setMaze(workspace, before);
          simulator.send({ type: "reset" });
        },
      },
    });
    onChosen?.();
  }

  return (
    <div className={styles["presets"]}>
      <ul className={styles["grid"]} aria-label={t("presets.presets")}>
        {mazePresets.map((preset) => {
          const isOpen = preset.maze.blocks.join() === blocks.join();
          return (
            <li key={preset.id} className={styles["item"]}>
              <button
                type="button"
                className={styles["card"]}
                aria-current={isOpen}
                onClick={() => choose(preset)}
              >
                <span className={styles["frame"]}>
                  <MazePicture maze={preset.maze} />
                </span>
                <span className={styles["title"]}>{t(`presets.${preset.id}.title`)}</span>
                <span className={styles["hint"]}>{t(`presets.${preset.id}.hint`)}</span>
              </button>
            </li>
          );
        })}
      </ul>
      <p className={styles["note"]}>{t("presets.note")}</p>
    </div>
  );
}
