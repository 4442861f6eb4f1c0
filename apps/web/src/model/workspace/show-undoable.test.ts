import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { createScreenStore } from "../screen/screen-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "./workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { showUndoable } from "./show-undoable.ts";

function afterAnEdit() {
  const screen = createScreenStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  setMaze(workspace, { ...firstMaze, goals: [] });
  showUndoable({ screen, workspace }, createI18n(en), "Goal removed.");
  return { screen, workspace };
}

describe("a side effect of an edit", () => {
  it("shows a message, and Undo reverts the edit and dismisses the message", () => {
    const { screen, workspace } = afterAnEdit();
    const [message] = screen.getState().messages;
    expect(message).toMatchObject({ tone: "info", text: "Goal removed." });
    message?.action?.run();
    expect(workspace.getState().maze).toBe(firstMaze);
    expect(screen.getState().messages).toEqual([]);
  });

  it("offers no Undo once it would revert another edit", () => {
    const { screen, workspace } = afterAnEdit();
    setProgram(workspace, { ...firstProgram, default: "stop" });
    expect(screen.getState().messages).toEqual([]);
  });
});
