/** Replaces the maze without a step of the history, for a maze that the user has not edited. */
import type { MazeDocument } from "@corridor/maze";
import type { Workspace, WorkspaceStore } from "./workspace-store.ts";

/** Undo and Redo retain the new maze. They revert edits of the program, and of the name. */
export function replaceMaze(store: WorkspaceStore, maze: MazeDocument): void {
  const history = store.temporal;
  const { pause, resume } = history.getState();
  pause();
  store.setState({ maze });
  resume();
  const inMaze = (step: Partial<Workspace>): Partial<Workspace> => {
    const name = step.maze?.name ?? maze.name;
    return { ...step, maze: name === maze.name ? maze : { ...maze, name } };
  };
  history.setState(({ pastStates, futureStates }) => ({
    pastStates: pastStates.map(inMaze),
    futureStates: futureStates.map(inMaze),
  }));
}
