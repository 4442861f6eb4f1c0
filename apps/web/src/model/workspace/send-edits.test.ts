import type { RunDocument } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { createWorkspaceStore, openProject, setMaze, undo } from "./workspace-store.ts";
import { RunLoop } from "../../simulator/worker/run-loop.ts";
import { loadRun } from "../../simulator/worker/testing/load-run.ts";
import type { ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { sendEdits } from "./send-edits.ts";

const maze = { ...firstMaze, name: "Recorded" };
const program = { ...firstProgram, name: "Recorded" };
const edited = { ...firstMaze, name: "Edited meanwhile" };

/** A second of a run of other documents. */
function recorded(): RunDocument {
  let time = 0;
  const loop = new RunLoop(maze, program, () => time);
  loop.run();
  for (; time < 1000; time += 100) loop.advance();
  const written = loop.saveRun();
  if (!written.ok) throw new Error(written.reason);
  return written.run;
}

/** A page whose messages reach the real run when the test delivers them. */
function newPage() {
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const loop = new RunLoop(firstMaze, firstProgram, () => 0);
  const waiting: ToWorker[] = [];
  const sent: ToWorker["type"][] = [];
  sendEdits(workspace, {
    send: (message) => {
      waiting.push(message);
      sent.push(message.type);
    },
  });
  const deliver = () => {
    for (const message of waiting.splice(0)) {
      if (message.type === "edit-maze") loop.editMaze(message.maze);
      if (message.type === "edit-program") loop.editProgram(message.program);
    }
  };
  const inputs = () => {
    const written = loop.saveRun();
    return written.ok ? written.run.inputs : null;
  };
  /** the documents of the worker's run */
  const known = () => {
    loop.now();
    const written = loop.saveRun();
    if (!written.ok) throw new Error(written.reason);
    const last = written.run.inputs.findLast((input) => input.do === "maze");
    return last?.maze.name ?? written.run.maze.name;
  };
  return { workspace, loop, sent, deliver, inputs, known };
}

describe("an edit", () => {
  it("reaches the worker, and nothing else does", () => {
    const { workspace, sent } = newPage();
    setMaze(workspace, maze);
    expect(sent).toEqual(["edit-maze"]);
    openProject(workspace, firstMaze, program);
    expect(sent).toEqual(["edit-maze", "edit-maze", "edit-program"]);
  });

  it("is none if its run was just opened with it: the run retains its inputs", () => {
    const { workspace, loop, deliver, inputs } = newPage();
    const run = recorded();
    loadRun(loop, run);
    openProject(workspace, structuredClone(maze), structuredClone(program));
    deliver();
    expect(inputs()).toEqual(run.inputs);
    setMaze(workspace, firstMaze);
    undo(workspace);
    deliver();
    expect(inputs()?.filter((input) => input.do === "maze")).toHaveLength(1);
  });

  it.each([
    { name: "before the run was there", isEarly: true },
    { name: "before the page received the run", isEarly: false },
  ])("while a run was opened, $name, leaves page and worker with one maze", ({ isEarly }) => {
    const { workspace, loop, deliver, known } = newPage();
    setMaze(workspace, edited);
    if (isEarly) deliver();
    const loaded = loadRun(loop, recorded());
    deliver();
    if (loaded.ok) openProject(workspace, loaded.maze, loaded.program);
    deliver();
    expect(known()).toBe(workspace.getState().maze.name);
    expect(known()).toBe("Recorded");
  });

  it("equal to a run's document that was never displayed still reaches the worker", () => {
    const { workspace, loop, deliver, known } = newPage();
    loadRun(loop, recorded());
    setMaze(workspace, edited);
    setMaze(workspace, maze);
    deliver();
    expect(known()).toBe("Recorded");
  });
});
