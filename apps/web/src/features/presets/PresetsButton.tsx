/** Opens the presets from the top bar. */
import { ChevronDown, LayoutGrid } from "lucide";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import { LazyPresetsPanel } from "./lazy-presets-panel.ts";
import type { PresetsPanelProps } from "./PresetsPanel.tsx";
import styles from "./presets.module.css";

export function PresetsButton({ algorithms }: Pick<PresetsPanelProps, "algorithms">) {
  const { t } = useTranslation();
  const { screen } = useServices();
  const menu = usePopover();
  // If the window shrinks to a phone's size, its sheet displays the presets.
  const onOpenChange = (isOpen: boolean): void => {
    menu.panel.onOpenChange(isOpen);
    screen.setState({ sheetTab: isOpen ? "presets" : null });
  };
  return (
    <>
      <Button kind="quiet" icon={<Icon of={LayoutGrid} />} {...menu.trigger}>
        {t("presets.presets")}
        <Icon of={ChevronDown} />
      </Button>
      <Popover
        {...menu.panel}
        onOpenChange={onOpenChange}
        label={t("presets.presets")}
        align="end"
        className={styles["popover"]}
      >
        <LazyPresetsPanel algorithms={algorithms} onChosen={menu.close} />
      </Popover>
    </>
  );
}
