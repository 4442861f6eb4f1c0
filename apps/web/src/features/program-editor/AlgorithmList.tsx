/** The preset algorithms as menu items. Loads when the menu opens. */
import { programPresets } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { MenuItem } from "../../ui/Popover.tsx";
import { AlgorithmChoice } from "./AlgorithmChoice.tsx";

export function AlgorithmList({ onChosen }: { onChosen: () => void }) {
  const { t } = useTranslation();
  return (
    <AlgorithmChoice onChosen={onChosen}>
      {(choose) =>
        programPresets.map(({ id, program }) => (
          <MenuItem
            key={id}
            note={t(`program.preset.${id}.note`)}
            staysOpen
            onSelect={() => choose({ ...program, name: t(`program.preset.${id}.name`) })}
          >
            {t(`program.preset.${id}.name`)}
          </MenuItem>
        ))
      }
    </AlgorithmChoice>
  );
}
