/**
 * The documents that the user edits, with one history: undo reverts the last edit, whether of the
 * maze or of the program. Independent of React; actions call the pure edit functions of the
 * packages.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { temporal } from "zundo";
import { createStore } from "zustand/vanilla";

export interface Workspace {
  maze: MazeDocument;
  program: ProgramDocument;
  /** one id per rule, so that a line's focus and badge move with it */
  lineIds: readonly number[];
  /** returns the edited program under its new name */
  named: NameEdit;
}

type NameEdit = (before: ProgramDocument, after: ProgramDocument) => ProgramDocument;

/** Largest number of undo steps. */
const HISTORY_LIMIT = 200;

/** Creates ids for lines; ids are unique within the page. */
let lastLineId = 0;
export function newLineIds(count: number): number[] {
  return Array.from({ length: count }, () => ++lastLineId);
}

export function createWorkspaceStore(
  maze: MazeDocument,
  program: ProgramDocument,
  named: NameEdit = (_before, after) => after,
) {
  const lineIds = newLineIds(program.rules.length);
  return createStore<Workspace>()(
    temporal((): Workspace => ({ maze, program, lineIds, named }), {
      limit: HISTORY_LIMIT,
      equality: (a, b) => a.maze === b.maze && a.program === b.program,
    }),
  );
}

export type WorkspaceStore = ReturnType<typeof createWorkspaceStore>;

/** Replaces the maze, as one step of the history. */
export function setMaze(store: WorkspaceStore, maze: MazeDocument): void {
  store.setState({ maze });
}

/** Replaces the program. Without ids, lines retain theirs if their number is the same. */
export function setProgram(
  store: WorkspaceStore,
  program: ProgramDocument,
  lineIds?: readonly number[],
): void {
  const { program: before, lineIds: ids, named } = store.getState();
  const count = program.rules.length;
  store.setState({
    program: named(before, program),
    lineIds: lineIds ?? (count === ids.length ? ids : newLineIds(count)),
  });
}

/** Opens other documents (another stored project, a link) with an empty history. */
export function openProject(
  store: WorkspaceStore,
  maze: MazeDocument,
  program: ProgramDocument,
): void {
  store.setState({ maze, program, lineIds: newLineIds(program.rules.length) });
  store.temporal.getState().clear();
}

export function undo(store: WorkspaceStore): void {
  store.temporal.getState().undo();
}

export function redo(store: WorkspaceStore): void {
  store.temporal.getState().redo();
}

/** The stroke of each store that has not ended. */
const openStrokes = new WeakMap<WorkspaceStore, () => void>();

/**
 * Groups several edits (a drag over many cells) into one undo step. Ends the stroke before it: a
 * press on the stage comes before the field that has the focus loses it.
 * @returns a function that ends the stroke
 */
export function beginStroke(store: WorkspaceStore): () => void {
  openStrokes.get(store)?.();
  const { maze, program, lineIds } = store.getState();
  const history = store.temporal;
  const { pastStates } = history.getState();
  history.getState().pause();
  const end = (): void => {
    if (openStrokes.get(store) !== end) return;
    openStrokes.delete(store);
    history.getState().resume();
    const after = store.getState();
    if (after.maze === maze && after.program === program) return;
    // Another project was opened meanwhile: the stroke belongs to the previous one.
    if (history.getState().pastStates !== pastStates) return;
    history.setState({
      pastStates: [...history.getState().pastStates, { maze, program, lineIds }].slice(
        -HISTORY_LIMIT,
      ),
      futureStates: [],
    });
  };
  openStrokes.set(store, end);
  return end;
}
