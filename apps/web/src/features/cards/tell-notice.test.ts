import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../worker/first-work.ts";
import { createRunStore } from "../../stores/run-store.ts";
import { createScreenStore } from "../../stores/screen-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "../../stores/workspace-store.ts";
import { tellNotice } from "./tell-notice.ts";

function told() {
  const screen = createScreenStore();
  const run = createRunStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  run.setState({ nowTick: 900 });
  const words = { t: ((key: string) => key) as never };
  tellNotice({ screen, workspace, run, words }, { kind: "circles", line: 0, cell: 3, times: 3 });
  return { run, workspace, messages: () => screen.getState().messages };
}

describe("the message that the robot gets nowhere", () => {
  it("stays while the same run goes on, and leads to the line", () => {
    const { run, messages } = told();
    run.setState({ nowTick: 901 });
    expect(messages()).toMatchObject([{ stays: true, action: { label: "cards.loop.show" } }]);
  });

  it.each([
    {
      name: "another program",
      change: ({ workspace }: ReturnType<typeof told>) =>
        setProgram(workspace, { ...firstProgram, rules: [] }),
    },
    {
      name: "another maze",
      change: ({ workspace }: ReturnType<typeof told>) =>
        setMaze(workspace, { ...firstMaze, name: "Other" }),
    },
    {
      name: "a new run",
      change: ({ run }: ReturnType<typeof told>) => run.setState({ nowTick: 0 }),
    },
  ])("goes with $name", ({ change }) => {
    const state = told();
    change(state);
    expect(state.messages()).toEqual([]);
  });
});
