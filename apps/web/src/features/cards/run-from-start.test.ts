import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import { createRunStore } from "../../model/run/run-store.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore, setProgram, undo } from "../../model/workspace/workspace-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import type { ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { showFixed } from "./run-from-start.ts";

/** A page whose robot stands where it bumped, and whose program was fixed. */
function fixed() {
  const sent: ToWorker[] = [];
  const screen = createScreenStore();
  const run = createRunStore();
  const paused = snapshotOf({ state: "paused", tick: 300 });
  run.setState({ snapshot: paused, nowTick: 300 });
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  setProgram(workspace, { ...firstProgram, default: "left 90" });
  const simulator = { send: (message: ToWorker) => void sent.push(message) };
  showFixed({ screen, run, workspace, simulator, words: { t: (key: string) => key } as never });
  return { sent, run, workspace, paused, message: () => screen.getState().messages[0] };
}

it("offers a run from the start, for as long as the robot stands at the wall", () => {
  const { sent, run, paused, message } = fixed();
  run.setState({ snapshot: { ...paused } });
  expect(message()).toMatchObject({ text: "cards.fix.done", stays: true });
  message()?.action?.run();
  expect(sent).toEqual([{ type: "reset" }, { type: "run" }]);
});

it.each([
  { how: "drives on", change: { snapshot: snapshotOf({ state: "running", tick: 301 }) } },
  { how: "is put back to its start", change: { nowTick: 0 } },
  {
    how: "has bumped again, at a speed that shows nothing in between",
    change: { snapshot: snapshotOf({ state: "paused", tick: 420 }), nowTick: 420 },
  },
])("withdraws the offer once the robot $how", ({ change }) => {
  const { run, message } = fixed();
  run.setState(change);
  expect(message()).toBeUndefined();
});

it("withdraws the message once Undo reverts the fix", () => {
  const { workspace, message } = fixed();
  undo(workspace);
  expect(message()).toBeUndefined();
});
