import type { Fix } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { newLineIds, setProgram, type WorkspaceStore } from "./workspace-store.ts";

/**
 * Applies a fix to the workspace as one step of the history. Every line retains its id.
 * @param fixed the workspace's program with the fix applied
 */
export function setFixedProgram(workspace: WorkspaceStore, fix: Fix, fixed: ProgramDocument): void {
  setProgram(workspace, fixed, idsAfter(fix, workspace.getState().lineIds));
}

function idsAfter(fix: Fix, ids: readonly number[]): readonly number[] {
  switch (fix.kind) {
    case "move":
      return ids.toSpliced(fix.line, 1).toSpliced(fix.to, 0, ...ids.slice(fix.line, fix.line + 1));
    case "delete":
      return ids.toSpliced(fix.line, 1);
    case "insert":
      return ids.toSpliced(fix.at, 0, ...newLineIds(1));
    case "action":
    case "number":
    case "condition":
      return ids;
  }
}
