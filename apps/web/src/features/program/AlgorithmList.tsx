/** The ready-made algorithms, as their menu offers them; it comes when the menu is opened. */
import { programPresets } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import { MenuItem } from "../../ui/Popover.tsx";
import { chooseAlgorithm } from "./choose-algorithm.ts";

export function AlgorithmList() {
  const { t, i18n } = useTranslation();
  const services = useServices();
  return programPresets.map(({ id, program }) => (
    <MenuItem
      key={id}
      note={t(`program.preset.${id}.note`)}
      onSelect={() => {
        const name = t(`program.preset.${id}.name`);
        chooseAlgorithm(services, i18n, { ...program, name });
      }}
    >
      {t(`program.preset.${id}.name`)}
    </MenuItem>
  ));
}
