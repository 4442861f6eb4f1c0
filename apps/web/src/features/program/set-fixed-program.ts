import type { Fix } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { newLineIds, setProgram, type WorkspaceStore } from "../../stores/workspace-store.ts";

/**
 * Applies a fix to the workspace as one step of the history. Every line retains its id.
 * @param mended the workspace's program with the fix applied
 */
export function takeMend(workspace: WorkspaceStore, mend: Fix, mended: ProgramDocument): void {
  setProgram(workspace, mended, idsAfter(mend, workspace.getState().lineIds));
}

function idsAfter(mend: Fix, ids: readonly number[]): readonly number[] {
  switch (mend.kind) {
    case "move":
      return ids
        .toSpliced(mend.line, 1)
        .toSpliced(mend.to, 0, ...ids.slice(mend.line, mend.line + 1));
    case "delete":
      return ids.toSpliced(mend.line, 1);
    case "insert":
      return ids.toSpliced(mend.at, 0, ...newLineIds(1));
    case "action":
    case "number":
    case "condition":
      return ids;
  }
}
