/**
 * Generates a random maze from its kind, its size and its seed, which generates the same maze
 * anywhere.
 */
import { generateMaze, mazeKinds, type MazeDocument } from "@corridor/maze";
import { Dices } from "lucide";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { NumberInput } from "../../ui/NumberInput.tsx";
import { Segmented } from "../../ui/Segmented.tsx";
import { useNumberDraft } from "../../ui/use-number-draft.ts";
import { MazePicture } from "../../ui/MazePicture.tsx";
import { drawSeed, LEAST_SIDE, MOST_SEED, MOST_SIDE, randomChoice } from "./random-choice.ts";
import styles from "./random-maze.module.css";

export function RandomMaze({ onUse }: { onUse: (maze: MazeDocument) => void }) {
  const { t } = useTranslation();
  const { kind, side, seed } = useStore(randomChoice);
  const name = t(`presets.random.names.${kind}`, { side, seed });
  const maze = generateMaze({ kind, columns: side, rows: side, seed, name });
  return (
    <div className={styles["random"]}>
      <figure className={styles["preview"]}>
        <span className={styles["picture"]}>
          <MazePicture maze={maze} />
        </span>
        <figcaption className={styles["name"]}>{name}</figcaption>
      </figure>
      <div className={styles["choices"]}>
        <Segmented
          label={t("presets.random.kind")}
          value={kind}
          options={mazeKinds.map((each) => ({
            value: each,
            label: t(`presets.random.kinds.${each}`),
          }))}
          onChange={(next) => randomChoice.setState({ kind: next })}
        />
        <SizeSlider side={side} />
        <SeedField seed={seed} />
        <Button kind="primary" className={styles["use"]} onClick={() => onUse(maze)}>
          {t("presets.random.use")}
        </Button>
      </div>
    </div>
  );
}

function SizeSlider({ side }: { side: number }) {
  const { t } = useTranslation();
  const id = useId();
  const words = t("presets.random.squares", { side });
  return (
    <div className={styles["size"]}>
      <label htmlFor={id} className={styles["label"]}>
        {t("presets.random.size")}
      </label>
      <span className={styles["value"]}>{words}</span>
      <input
        id={id}
        type="range"
        className={styles["slider"]}
        min={LEAST_SIDE}
        max={MOST_SIDE}
        step={2}
        value={side}
        aria-valuetext={words}
        onChange={(event) => randomChoice.setState({ side: event.target.valueAsNumber })}
      />
    </div>
  );
}

function SeedField({ seed }: { seed: number }) {
  const { t } = useTranslation();
  const id = useId();
  const bounds = { min: 0, max: MOST_SEED, whole: true };
  const draft = useNumberDraft(seed, bounds, (next) => randomChoice.setState({ seed: next }));
  return (
    <div className={styles["seed"]}>
      <label htmlFor={id} className={styles["label"]}>
        {t("presets.random.seed")}
      </label>
      <NumberInput id={id} className={styles["number"]} draft={draft} errorId={`${id}-error`} />
      <Button
        icon={<Icon of={Dices} />}
        onClick={() => randomChoice.setState({ seed: drawSeed() })}
      >
        {t("presets.random.draw")}
      </Button>
      {draft.hasErrorRoom && (
        <div className={styles["error"]}>
          {draft.isInvalid && (
            <FieldError id={`${id}-error`}>
              {t("presets.random.seedError", { most: MOST_SEED })}
            </FieldError>
          )}
        </div>
      )}
    </div>
  );
}
