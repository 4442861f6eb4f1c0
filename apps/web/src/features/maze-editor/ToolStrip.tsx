/** Above the maze: the tools that edit squares, and the commands for the whole maze. */
import {
  Eraser,
  Flag,
  Grid2x2Plus,
  LocateFixed,
  Redo2,
  Ruler,
  Scaling,
  Undo2,
  type IconNode,
} from "lucide";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { tools, type Tool } from "../../model/screen/screen-store.ts";
import { redo, undo } from "../../model/workspace/workspace-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { lazyDialog } from "../../ui/lazy-part.tsx";
import { Segmented } from "../../ui/Segmented.tsx";
import { ViewMenu } from "./ViewMenu.tsx";
import { useRights, useTool } from "../../model/use-rights.ts";
import styles from "./tool-strip.module.css";

const ClearDialog = lazyDialog(async () => (await import("./ClearDialog.tsx")).ClearDialog);
const ResizeDialog = lazyDialog(async () => (await import("./ResizeDialog.tsx")).ResizeDialog);

const icons: Record<Tool, IconNode> = {
  blocks: Grid2x2Plus,
  start: LocateFixed,
  goal: Flag,
  measure: Ruler,
};

interface ToolStripProps {
  /** in the View menu */
  sound: ReactNode;
  /** before the View menu */
  children: ReactNode;
}

export function ToolStrip({ sound, children }: ToolStripProps) {
  const { screen, race } = useServices();
  const { t } = useTranslation();
  const isFixed = useRights()?.maze === false;
  const hasMeasure = useTool("measure");
  const tool = useStore(screen, (state) => state.tool);
  const hasRace = useStore(race, ({ ghosts }) => ghosts.length > 0);
  const [dialog, setDialog] = useState<"clear" | "resize" | null>(null);
  const close = (): void => setDialog(null);
  return (
    <div className={styles["strip"]} data-race={hasRace}>
      <div className={styles["tools"]}>
        <Segmented
          look="strip"
          label={t("stage.tools")}
          value={tool}
          options={tools
            .filter((value) => hasMeasure || value !== "measure")
            .map((value) => ({
              value,
              label: t(`stage.tool.${value}`),
              icon: <Icon of={icons[value]} />,
              fixed: isFixed && value !== "measure" ? t("stage.refused.maze-fixed") : undefined,
            }))}
          onChange={(value) => screen.setState({ tool: value })}
        />
      </div>
      <div className={styles["edits"]}>
        <HistoryButtons />
        {!isFixed && (
          <WholeMaze onClear={() => setDialog("clear")} onResize={() => setDialog("resize")} />
        )}
      </div>
      {children}
      <ViewMenu
        sound={sound}
        onClear={() => setDialog("clear")}
        onResize={() => setDialog("resize")}
      />
      <ClearDialog isOpen={dialog === "clear"} onClose={close} />
      <ResizeDialog isOpen={dialog === "resize"} onClose={close} />
    </div>
  );
}

/** Not rendered while a challenge fixes the maze. */
function WholeMaze({ onClear, onResize }: { onClear: () => void; onResize: () => void }) {
  const { t } = useTranslation();
  return (
    <>
      <Button
        kind="quiet"
        size="small"
        className={styles["whole"]}
        title={t("stage.clear")}
        icon={<Icon of={Eraser} />}
        onClick={onClear}
      >
        <span className={styles["word"]}>{t("stage.clear")}</span>
      </Button>
      <Button
        kind="quiet"
        size="small"
        className={styles["whole"]}
        title={t("stage.resize")}
        icon={<Icon of={Scaling} />}
        onClick={onResize}
      >
        <span className={styles["word"]}>{t("stage.resize")}</span>
      </Button>
    </>
  );
}

function HistoryButtons() {
  const { workspace } = useServices();
  const { t } = useTranslation();
  const canUndo = useStore(workspace.temporal, (history) => history.pastStates.length > 0);
  const canRedo = useStore(workspace.temporal, (history) => history.futureStates.length > 0);
  return (
    <>
      <IconButton label={t("stage.undo")} disabled={!canUndo} onClick={() => undo(workspace)}>
        <Icon of={Undo2} isDirectional />
      </IconButton>
      <IconButton label={t("stage.redo")} disabled={!canRedo} onClick={() => redo(workspace)}>
        <Icon of={Redo2} isDirectional />
      </IconButton>
    </>
  );
}
