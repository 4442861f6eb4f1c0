import type { Diagnosis } from "@corridor/coach";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { createRunStore } from "../../model/run/run-store.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import {
  createWorkspaceStore,
  setMaze,
  setProgram,
} from "../../model/workspace/workspace-store.ts";
import { showDiagnosis } from "./show-diagnosis.ts";

const diagnosis: Diagnosis = {
  event: { kind: "circles", tick: 900, line: 0, cell: 3, times: 3 },
  cause: {
    kind: "extra",
    line: 0,
    moment: {
      tick: 60,
      line: 0,
      when: null,
      action: "left 90",
      readings: { front: 50, right: 50, back: 50, left: 250 },
    },
  },
  fixes: [{ kind: "delete", line: 0 }],
};

async function shown() {
  const screen = createScreenStore();
  const run = createRunStore();
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  run.setState({ nowTick: 900 });
  const words = {
    t: ((key: string) => key) as never,
    language: "en",
    loadNamespaces: () => Promise.resolve(),
  };
  await showDiagnosis(
    { screen, workspace, run, timeline: { waitedUpTo: () => 0 }, words },
    diagnosis,
  );
  return { run, workspace, messages: () => screen.getState().messages };
}

describe("the message that the robot gets nowhere", () => {
  it("stays while the same run continues, and leads to the line", async () => {
    const { run, messages } = await shown();
    run.setState({ nowTick: 901 });
    expect(messages()).toMatchObject([{ stays: true, action: { label: "diagnosis:show" } }]);
  });

  it.each([
    {
      name: "another program",
      change: ({ workspace }: Awaited<ReturnType<typeof shown>>) =>
        setProgram(workspace, { ...firstProgram, rules: [] }),
    },
    {
      name: "another maze",
      change: ({ workspace }: Awaited<ReturnType<typeof shown>>) =>
        setMaze(workspace, { ...firstMaze, name: "Other" }),
    },
    {
      name: "the card of a bump",
      change: ({ run }: Awaited<ReturnType<typeof shown>>) =>
        run.setState({
          event: {
            kind: "bump",
            tick: 960,
            pose: { x: 50, y: 50, heading: 0 },
            line: 0,
            driver: "program",
            bumps: 1,
            cause: null,
            diagnosis: { event: { kind: "late", tick: 960 }, cause: null, fixes: [] },
            program: null,
          },
        }),
    },
    {
      name: "a new run",
      change: ({ run }: Awaited<ReturnType<typeof shown>>) => run.setState({ nowTick: 0 }),
    },
  ])("goes with $name", async ({ change }) => {
    const state = await shown();
    change(state);
    expect(state.messages()).toEqual([]);
  });
});
