/** What the stage shows besides maze and robot, and the figures that its measures rest on. */
import { ChevronDown, Eye } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { Button } from "../../ui/Button.tsx";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import styles from "./tool-strip.module.css";

const choices = ["showBeams", "showTrail", "showRulers"] as const;

export function ViewMenu() {
  const { screen } = useServices();
  const { t } = useTranslation();
  const state = useStore(screen);
  const menu = usePopover();
  return (
    <div className={styles["view"]}>
      <Button {...menu.trigger} kind="quiet" size="small" icon={<Eye aria-hidden="true" />}>
        <span className={styles["word"]}>{t("stage.view")}</span>
        <ChevronDown aria-hidden="true" />
      </Button>
      <Popover {...menu.panel} label={t("stage.view")} align="right">
        <div className={styles["choices"]}>
          {choices.map((choice) => (
            <Checkbox
              key={choice}
              label={t(`stage.${choice}`)}
              checked={state[choice]}
              onChange={(isShown) => screen.setState({ [choice]: isShown })}
            />
          ))}
          <p className={styles["figures"]}>{t("stage.figures")}</p>
        </div>
      </Popover>
    </div>
  );
}
