/** Above the maze: the tools that edit squares, and the commands for the whole maze. */
import { Eraser, Flag, Grid2x2Plus, LocateFixed, Ruler, Scaling, type IconNode } from "lucide";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { tools, type Tool } from "../../model/screen/screen-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
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
  /** undo and redo, or null */
  history: ReactNode;
  /** in the View menu */
  sound: ReactNode;
  /** before the View menu */
  children: ReactNode;
}

export function ToolStrip({ history, sound, children }: ToolStripProps) {
  const { screen, race, run } = useServices();
  const { t } = useTranslation();
  const isFixed = useRights()?.maze === false;
  const hasMeasure = useTool("measure");
  const tool = useStore(screen, (state) => state.tool);
  const isRacing = useStore(race, ({ ghosts }) => ghosts.length > 0);
  // A past run is offered for a race.
  const isPast = useStore(run, ({ view }) => view !== "now");
  const [dialog, setDialog] = useState<"clear" | "resize" | null>(null);
  const close = (): void => setDialog(null);
  return (
    <div className={styles["strip"]} data-race={isRacing || isPast}>
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
      <div className={styles["edits"]} data-history={history !== null}>
        {history}
        {!isFixed && (
          <WholeMaze onClear={() => setDialog("clear")} onResize={() => setDialog("resize")} />
        )}
      </div>
      {children}
      <ViewMenu
        hasHistory={history !== null}
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
