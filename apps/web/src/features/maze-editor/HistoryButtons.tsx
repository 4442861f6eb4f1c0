/** Undo and redo of the maze and the program, beside the tools of the stage. */
import { Redo2, Undo2 } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { redo, undo } from "../../model/workspace/workspace-store.ts";
import { IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";

export function HistoryButtons() {
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
