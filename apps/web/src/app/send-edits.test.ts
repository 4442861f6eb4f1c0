import { describe, expect, it } from "vitest";
import { createWorkspaceStore, openWork, setMaze, undo } from "../stores/workspace-store.ts";
import type { FromWorker, ToWorker } from "../worker/worker-messages.ts";
import { firstMaze, firstProgram } from "./first-visit.ts";
import { sendEdits } from "./send-edits.ts";

const maze = { ...firstMaze, name: "Recorded" };
const program = { ...firstProgram, name: "Recorded" };

function newPage() {
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const sent: ToWorker["type"][] = [];
  let hear: (message: FromWorker) => void = () => undefined;
  sendEdits(workspace, {
    send: ({ type }) => sent.push(type),
    listen: (listener) => {
      hear = listener;
      return () => undefined;
    },
  });
  const loadRun = () => hear({ type: "run-loaded", id: 1, loaded: { ok: true, maze, program } });
  return { workspace, sent, loadRun };
}

describe("what is edited", () => {
  it("goes to the worker, and only that", () => {
    const { workspace, sent } = newPage();
    setMaze(workspace, maze);
    expect(sent).toEqual(["edit-maze"]);
    openWork(workspace, firstMaze, program);
    expect(sent).toEqual(["edit-maze", "edit-maze", "edit-program"]);
  });

  it("does not go back to where it came from: a run keeps the inputs that it was opened with", () => {
    const { workspace, sent, loadRun } = newPage();
    loadRun();
    openWork(workspace, structuredClone(maze), program);
    expect(sent).toEqual([]);
    setMaze(workspace, firstMaze);
    undo(workspace);
    expect(sent).toEqual(["edit-maze", "edit-maze"]);
  });
});
