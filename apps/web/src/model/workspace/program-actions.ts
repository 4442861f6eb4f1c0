/**
 * Edits of the program on the screen. Each is one step of the history and preserves line ids, so
 * that focus and badges stay with their line. React-free.
 */
import {
  addRule,
  MAX_RULES,
  moveRule,
  numberOf,
  removeRule,
  setCondition,
  setNumber,
  type ConditionKind,
  type ProgramDocument,
  type ProgramEdit,
} from "@corridor/program";
import { newLineIds, setProgram, undo, type WorkspaceStore } from "./workspace-store.ts";

/** Applies an edit to the workspace. A refused edit changes nothing. */
export function applyEdit(
  workspace: WorkspaceStore,
  edit: ProgramEdit,
  lineIds?: readonly number[],
): void {
  if (!edit.ok || edit.program === workspace.getState().program) return;
  setProgram(workspace, edit.program, lineIds);
}

/**
 * Adds a line at the end.
 * @returns its id, or null if the program is full
 */
export function addLine(workspace: WorkspaceStore): number | null {
  const { program, lineIds } = workspace.getState();
  const edit = addRule(program);
  if (!edit.ok) return null;
  const ids = newLineIds(1);
  applyEdit(workspace, edit, [...lineIds, ...ids]);
  return ids[0] ?? null;
}

/** Moves a line up (-1) or down (1). */
export function moveLine(workspace: WorkspaceStore, index: number, by: -1 | 1): void {
  const { program, lineIds } = workspace.getState();
  const id = lineIds[index];
  const edit = moveRule(program, index, by);
  if (!edit.ok || id === undefined) return;
  const place = Math.max(0, Math.min(lineIds.length - 1, index + by));
  applyEdit(workspace, edit, lineIds.toSpliced(index, 1).toSpliced(place, 0, id));
}

/**
 * Deletes a line.
 * @returns a function that restores it: by undo if nothing else was edited since, otherwise as a
 *   new step of the history. It returns false if the program has no room for the line: it has the
 *   maximum number of lines, which a task may limit
 */
export function deleteLine(
  workspace: WorkspaceStore,
  index: number,
): (maxLines?: number) => boolean {
  const { program, lineIds } = workspace.getState();
  const rule = program.rules[index];
  const id = lineIds[index];
  const edit = removeRule(program, index);
  if (!edit.ok || rule === undefined || id === undefined) return () => true;
  applyEdit(workspace, edit, lineIds.toSpliced(index, 1));
  const after = workspace.getState();
  return (maxLines = MAX_RULES) => {
    const now = workspace.getState();
    if (now.program === after.program && now.maze === after.maze) {
      undo(workspace);
    } else if (!now.lineIds.includes(id)) {
      if (now.program.rules.length >= maxLines) return false;
      const rules = now.program.rules.toSpliced(index, 0, rule);
      setProgram(workspace, { ...now.program, rules }, now.lineIds.toSpliced(index, 0, id));
    }
    return true;
  };
}

/** Numbers of removed conditions by line id, in case a condition is chosen again. */
export type RememberedNumbers = Map<number, number>;

/**
 * Sets a condition, or none. A line that gets a condition again gets its old number, otherwise 50.
 */
export function chooseCondition(
  workspace: WorkspaceStore,
  index: number,
  kind: ConditionKind | null,
  remembered: RememberedNumbers,
): void {
  const { program, lineIds } = workspace.getState();
  const id = lineIds[index];
  const before = program.rules[index]?.when;
  if (id === undefined || before === undefined) return;
  if (before !== null) remembered.set(id, numberOf(before));

  const edit = setCondition(program, index, kind);
  const number = remembered.get(id);
  if (!edit.ok || kind === null || before !== null || number === undefined) {
    applyEdit(workspace, edit);
    return;
  }
  const withNumber = setNumber(edit.program, index, number);
  applyEdit(workspace, withNumber.ok ? withNumber : edit);
}

/** Replaces the program with a preset, as one step of the history. */
export function loadProgram(workspace: WorkspaceStore, program: ProgramDocument): void {
  setProgram(workspace, program, newLineIds(program.rules.length));
}
