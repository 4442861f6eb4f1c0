import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../worker/first-project.ts";
import { createScreenStore } from "../../stores/screen-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "../../stores/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { tellUndoable } from "./show-undoable.ts";

function afterAnEdit() {
  const screen = createScreenStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  setMaze(workspace, { ...firstMaze, goals: [] });
  tellUndoable({ screen, workspace }, createI18n(en), "Goal removed.");
  return { screen, workspace };
}

describe("what an edit took along", () => {
  it("is told, and Undo brings it back and takes the message away", () => {
    const { screen, workspace } = afterAnEdit();
    const [message] = screen.getState().messages;
    expect(message).toMatchObject({ tone: "info", text: "Goal removed." });
    message?.action?.run();
    expect(workspace.getState().maze).toBe(firstMaze);
    expect(screen.getState().messages).toEqual([]);
  });

  it("offers no Undo any more once that would take back another edit", () => {
    const { screen, workspace } = afterAnEdit();
    setProgram(workspace, { ...firstProgram, default: "stop" });
    expect(screen.getState().messages).toEqual([]);
  });
});
