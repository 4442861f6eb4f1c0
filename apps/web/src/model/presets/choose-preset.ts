/**
 * Replaces the open maze, with a message that can undo it. A program that the student wrote stays;
 * an empty program replaces an example or a preset.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { DriverName } from "@corridor/protocol";
import type { i18n } from "i18next";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import {
  dismiss,
  dismissOfProject,
  showMessage,
  type ScreenStore,
} from "../screen/screen-store.ts";
import {
  newLineIds,
  setMaze,
  setProgram,
  undo,
  type WorkspaceStore,
} from "../workspace/workspace-store.ts";
import type { RunStore } from "../run/run-store.ts";
import { dismissOnce } from "../workspace/dismiss-once.ts";
import { programForMaze } from "../workspace/own-program.ts";

interface ChoicePorts {
  workspace: WorkspaceStore;
  simulator: Pick<SimulatorClient, "send">;
  screen: ScreenStore;
  run: Pick<RunStore, "getState">;
}

/** Resets the robot to the start of the maze. Maze and program are one step of the history. */
export function chooseMaze(
  { workspace, simulator, screen, run }: ChoicePorts,
  words: Pick<i18n, "t">,
  maze: MazeDocument,
): void {
  const before = workspace.getState();
  const program = programForMaze(before.program, words);
  if (program === null) setMaze(workspace, maze);
  else workspace.setState({ maze, program, lineIds: newLineIds(program.rules.length) });
  simulator.send({ type: "reset" });
  const after = workspace.getState();
  // One message at a time: on a phone, several would cover the robot.
  dismissOfProject(screen);
  const message = showMessage(screen, {
    tone: "info",
    isOfProject: true,
    text: words.t(`presets.${textOf(maze, program, run.getState().nowDriver)}`, {
      name: maze.name,
    }),
    action: {
      label: words.t("presets.undo"),
      run: () => {
        dismiss(screen, message);
        // Later edits have their own steps in the history, which stay. The old maze becomes a new
        // step.
        const now = workspace.getState();
        if (now.maze === after.maze && now.program === after.program) undo(workspace);
        else {
          setMaze(workspace, before.maze);
          if (now.program === program) setProgram(workspace, before.program, before.lineIds);
        }
        simulator.send({ type: "reset" });
      },
    },
  });
  // Undo is in several places. Once the old maze is back, the new one is no longer open.
  dismissOnce({ screen, workspace }, message, (now) => now.maze === before.maze);
}

/** Scripts that drive the robot do not use the program of the page. */
function textOf(maze: MazeDocument, program: ProgramDocument | null, driver: DriverName | null) {
  if (program === null) return "chosen";
  if (maze.goals.length === 0) return "chosenNoGoal";
  return driver === "remote" ? "chosenRemote" : "chosenEmpty";
}
