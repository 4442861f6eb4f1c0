/** The preset algorithms as cards. */
import { isSameBehaviour, programPresets } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { ChoiceCard } from "../../ui/ChoiceCard.tsx";
import { AlgorithmChoice } from "./AlgorithmChoice.tsx";
import styles from "./algorithm-choice.module.css";

export function AlgorithmCards({ onChosen }: { onChosen?: (() => void) | undefined }) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const program = useStore(workspace, (state) => state.program);
  return (
    <AlgorithmChoice onChosen={onChosen}>
      {(choose) => (
        <ul className={styles["cards"]}>
          {programPresets.map((preset) => {
            const name = t(`program.preset.${preset.id}.name`);
            return (
              <ChoiceCard
                key={preset.id}
                title={name}
                hint={t(`program.preset.${preset.id}.note`)}
                isOpen={isSameBehaviour(preset.program, program)}
                onChoose={() => choose({ ...preset.program, name })}
              />
            );
          })}
        </ul>
      )}
    </AlgorithmChoice>
  );
}
