/**
 * Selects the mazes to try: their kind, their size, and the seeds, which generate the same mazes
 * anywhere.
 */
import { mazeKinds } from "@corridor/maze";
import { ArrowRight } from "lucide";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { NumberInput } from "../../ui/NumberInput.tsx";
import { Segmented } from "../../ui/Segmented.tsx";
import { useNumberDraft } from "../../ui/use-number-draft.ts";
import styles from "./other-mazes.module.css";
import {
  LEAST_TRIAL_SIDE,
  MOST_FIRST_SEED,
  MOST_TRIAL_SIDE,
  trialChoice,
  TRIALS,
} from "./trials.ts";

export function TrialChoices() {
  const { t } = useTranslation();
  const kind = useStore(trialChoice, (choice) => choice.kind);
  return (
    <div className={styles["choices"]}>
      <Segmented
        label={t("presets.random.kind")}
        value={kind}
        options={mazeKinds.map((each) => ({
          value: each,
          label: t(`presets.random.kinds.${each}`),
        }))}
        onChange={(next) => trialChoice.setState({ kind: next })}
      />
      <SizeSlider />
      <SeedField />
    </div>
  );
}

function SizeSlider() {
  const { t } = useTranslation();
  const id = useId();
  const side = useStore(trialChoice, (choice) => choice.side);
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
        min={LEAST_TRIAL_SIDE}
        max={MOST_TRIAL_SIDE}
        step={2}
        value={side}
        aria-valuetext={words}
        onChange={(event) => trialChoice.setState({ side: event.target.valueAsNumber })}
      />
    </div>
  );
}

function SeedField() {
  const { t } = useTranslation(["words", "otherMazes"], { useSuspense: false });
  const id = useId();
  const first = useStore(trialChoice, (choice) => choice.first);
  const bounds = { min: 0, max: MOST_FIRST_SEED, whole: true };
  const draft = useNumberDraft(first, bounds, (next) => trialChoice.setState({ first: next }));
  const next = Math.min(MOST_FIRST_SEED, first + TRIALS);
  return (
    <div className={styles["seeds"]}>
      <label htmlFor={id} className={styles["label"]}>
        {t("otherMazes:firstSeed")}
      </label>
      <NumberInput id={id} className={styles["number"]} draft={draft} errorId={`${id}-error`} />
      <span className={styles["value"]}>
        {t("otherMazes:seeds", { first, last: first + TRIALS - 1 })}
      </span>
      <Button onClick={() => trialChoice.setState({ first: next })}>
        {t("otherMazes:next", { all: TRIALS })}
        <Icon of={ArrowRight} className={styles["onward"]} />
      </Button>
      {draft.hasErrorRoom && draft.isInvalid && (
        <div className={styles["error"]}>
          <FieldError id={`${id}-error`}>
            {t("presets.random.seedError", { most: MOST_FIRST_SEED })}
          </FieldError>
        </div>
      )}
    </div>
  );
}
