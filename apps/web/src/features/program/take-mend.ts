/** Takes a mend into the workspace: one step of the history, and every line keeps its id. */
import type { Fix } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { newLineIds, setProgram, type WorkspaceStore } from "../../stores/workspace-store.ts";

/** @param mended the workspace's program with the mend in it */
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
