import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore, setMaze } from "../../model/workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { chooseAlgorithm } from "./choose-algorithm.ts";

const leftWall = programPresets.find(({ id }) => id === "left-wall")?.program;
if (leftWall === undefined) throw new Error("a ready-made program is gone");
const chosen = leftWall;

function choose() {
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const screen = createScreenStore();
  chooseAlgorithm({ workspace, screen }, createI18n(en), chosen);
  return { workspace, messages: () => screen.getState().messages };
}

describe("a preset algorithm", () => {
  it("replaces the program, and the message restores the old one", () => {
    const { workspace, messages } = choose();
    expect(workspace.getState().program).toBe(chosen);
    messages()[0]?.action?.run();
    expect(workspace.getState().program).toBe(firstProgram);
  });

  it("leaves an edit of the maze alone: no Undo of its message is left to take that back", () => {
    const { workspace, messages } = choose();
    const maze = { ...firstMaze, goals: [] };
    setMaze(workspace, maze);
    messages()[0]?.action?.run();
    expect(workspace.getState()).toMatchObject({ maze, program: chosen });
    expect(messages()).toEqual([]);
  });
});
