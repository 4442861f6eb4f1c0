/** The content of the View menu. */
import { Eraser, MessageSquareText, Redo2, Scaling, Undo2 } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { redo, undo } from "../../model/workspace/workspace-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { MenuItem } from "../../ui/Popover.tsx";
import { useRights } from "../../model/use-rights.ts";
import { describeRobot } from "../../model/speech/describe-later.ts";
import { ZoomButtons } from "./ZoomButtons.tsx";
import styles from "./tool-strip.module.css";

const choices = ["showBeams", "showTrail", "showRulers"] as const;

export interface ViewMenuProps {
  /** whether a narrow stage offers undo and redo here */
  hasHistory: boolean;
  sound: ReactNode;
  onClear: () => void;
  onResize: () => void;
}

/**
 * Includes the commands for which a phone has no room in the strip or the legend. A phone has no
 * rulers.
 */
export function ViewMenuContent({ hasHistory, sound, onClear, onResize }: ViewMenuProps) {
  const services = useServices();
  const { screen, simulator } = services;
  const { t, i18n } = useTranslation();
  const isFixed = useRights()?.maze === false;
  const state = useStore(screen);
  return (
    <div className={styles["choices"]}>
      {choices.map((choice) => (
        <div key={choice} className={styles[choice]}>
          <Checkbox
            label={t(`stage.${choice}`)}
            checked={state[choice]}
            onChange={(isShown) => screen.setState({ [choice]: isShown })}
          />
        </div>
      ))}
      <Checkbox
        label={t("stage.showMarks")}
        checked={state.showMarks !== false}
        onChange={(showMarks) => {
          screen.setState({ showMarks });
          simulator.send({ type: "hide-marks", isHidden: !showMarks });
        }}
      />
      <div className={styles["zoomItems"]}>
        <ZoomButtons size="large" />
      </div>
      <div className={styles["wholeItems"]}>
        <MenuItem
          icon={<Icon of={MessageSquareText} />}
          onSelect={() => void describeRobot(services, i18n)}
        >
          {t("speech.describe.button")}
        </MenuItem>
      </div>
      {hasHistory && <HistoryItems />}
      {!isFixed && (
        <div className={styles["wholeItems"]}>
          <MenuItem icon={<Icon of={Scaling} />} onSelect={onResize}>
            {t("stage.resize")}
          </MenuItem>
          <MenuItem icon={<Icon of={Eraser} />} onSelect={onClear}>
            {t("stage.clear")}
          </MenuItem>
        </div>
      )}
      {sound}
      <p className={styles["figures"]}>{t("stage.figures")}</p>
    </div>
  );
}

function HistoryItems() {
  const { workspace } = useServices();
  const { t } = useTranslation();
  const canUndo = useStore(workspace.temporal, (history) => history.pastStates.length > 0);
  const canRedo = useStore(workspace.temporal, (history) => history.futureStates.length > 0);
  return (
    <div className={styles["historyItems"]}>
      <MenuItem
        icon={<Icon of={Undo2} isDirectional />}
        disabled={!canUndo}
        onSelect={() => undo(workspace)}
      >
        {t("stage.undo")}
      </MenuItem>
      <MenuItem
        icon={<Icon of={Redo2} isDirectional />}
        disabled={!canRedo}
        onSelect={() => redo(workspace)}
      >
        {t("stage.redo")}
      </MenuItem>
    </div>
  );
}
