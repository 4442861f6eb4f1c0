/**
 * The documents that the user works on, and their one history: undo takes back the last edit,
 * whether of the maze or of the program. React-free; actions call the packages' pure edits.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { temporal } from "zundo";
import { createStore } from "zustand/vanilla";

export interface Workspace {
  maze: MazeDocument;
  program: ProgramDocument;
  /** one id a rule, so that a line keeps its focus and its badge's place when it moves */
  lineIds: readonly number[];
  /** an edited program under the name that it goes on with */
  named: NameEdit;
}

type NameEdit = (before: ProgramDocument, after: ProgramDocument) => ProgramDocument;

/** Steps that undo can take back. */
const HISTORY_LIMIT = 200;

/** New ids for the lines of a program; ids are unique within the page. */
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

/** Puts another or an edited maze in, as one step of the history. */
export function setMaze(store: WorkspaceStore, maze: MazeDocument): void {
  store.setState({ maze });
}

/** Puts another or an edited program in. Without ids, lines keep theirs if their number is the same. */
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

/** Opens other documents altogether (another saved work, a link): the history begins anew. */
export function openWork(
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

/**
 * Runs several edits (a drag over many cells) so that one undo takes them all back.
 * @returns a function that ends the stroke
 */
export function beginStroke(store: WorkspaceStore): () => void {
  const { maze, program, lineIds } = store.getState();
  const history = store.temporal;
  const { pastStates } = history.getState();
  history.getState().pause();
  return () => {
    history.getState().resume();
    const after = store.getState();
    if (after.maze === maze && after.program === program) return;
    // Another work was opened meanwhile: the stroke was one in the work before.
    if (history.getState().pastStates !== pastStates) return;
    history.setState({
      pastStates: [...history.getState().pastStates, { maze, program, lineIds }].slice(
        -HISTORY_LIMIT,
      ),
      futureStates: [],
    });
  };
}
