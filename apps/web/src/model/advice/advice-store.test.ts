import { setAction, setNumber, type ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { createChallengeStore } from "../challenge/challenge-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { createRunStore, type RunState } from "../run/run-store.ts";
import { createWorkspaceStore, setMaze, undo } from "../workspace/workspace-store.ts";
import { adviceOn, createAdviceStore, type AdvicePorts } from "./advice-store.ts";
import * as coach from "./coach.ts";
import { applyEdit } from "../workspace/program-actions.ts";
import { setFixedProgram } from "../workspace/set-fixed-program.ts";

/** The second line is a delayed turn just before a wall. */
const wrong: ProgramDocument = {
  ...firstProgram,
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "delayed left 90" },
  ],
};

/** A page with manual timers. `settle` runs the scheduled tasks. */
function setUp(program = wrong, load: AdvicePorts["load"] = async () => coach) {
  const workspace = createWorkspaceStore(firstMaze, program);
  const challenge = createChallengeStore();
  const run = createRunStore();
  const waiting: (() => void)[] = [];
  const advice = createAdviceStore({
    workspace,
    challenge,
    load,
    later: (task) => waiting.push(task),
    run,
  });
  const settle = async () => {
    for (const task of waiting.splice(0)) task();
    // Lets the coach load.
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  const lines = () => advice.getState().shown.map(({ line }) => line);
  const edit = (action: "left 90" | "delayed left 90") =>
    applyEdit(workspace, setAction(workspace.getState().program, 1, action));
  const drive = (state: "running" | "paused", moment: "bump" | null = null) => {
    const about = { kind: moment, tick: 1, driver: "program" };
    run.setState({
      snapshot: { state } as RunState["snapshot"],
      event: moment === null ? null : (about as RunState["event"]),
    });
  };
  return { workspace, advice, settle, lines, edit, drive };
}

describe("advice on the lines", () => {
  it("appears after the edits pause, and disappears at once", async () => {
    const { settle, lines, edit } = setUp();
    expect(lines()).toEqual([]);
    await settle();
    expect(lines()).toEqual([1]);
    edit("left 90");
    expect(lines()).toEqual([]);
    await settle();
    edit("delayed left 90");
    expect(lines()).toEqual([]);
    await settle();
    expect(lines()).toEqual([1]);
  });

  it("moves no line while the robot drives, and appears when it is paused", async () => {
    const { settle, lines, drive } = setUp();
    drive("running");
    await settle();
    expect(lines()).toEqual([]);
    drive("paused");
    expect(lines()).toEqual([1]);
  });

  it("moves no line at a bump, and appears with Reset or the next edit", async () => {
    const { settle, lines, edit, drive } = setUp();
    drive("running");
    await settle();
    drive("paused", "bump");
    expect(lines()).toEqual([]);
    drive("paused");
    expect(lines()).toEqual([1]);
    edit("left 90");
    drive("running");
    await settle();
    drive("paused", "bump");
    edit("delayed left 90");
    await settle();
    expect(lines()).toEqual([1]);
  });

  it("does not appear for a number that is half typed", async () => {
    const { workspace, settle, lines } = setUp({ ...wrong, rules: wrong.rules.slice(0, 1) });
    await settle();
    for (const number of [6, 60]) {
      applyEdit(workspace, setNumber(workspace.getState().program, 0, number));
    }
    await settle();
    expect(lines()).toEqual([]);
  });

  it("is that of the newest edit when the coach loads late", async () => {
    const { settle, lines, edit } = setUp();
    const coming = settle();
    edit("left 90");
    await coming;
    await settle();
    expect(lines()).toEqual([]);
  });

  it("follows the maze", async () => {
    const { workspace, settle, lines } = setUp({
      ...wrong,
      rules: [{ when: { sensor: "front", is: ">", than: 700 }, do: "turn 180" }],
    });
    await settle();
    expect(lines()).toEqual([]);
    setMaze(workspace, {
      ...firstMaze,
      blocks: [".."],
      start: { column: 0, row: 0, heading: "east" },
      goals: [],
    });
    await settle();
    expect(lines()).toEqual([0]);
  });

  it("is announced once, however often it appears and disappears", async () => {
    const { advice, settle, edit } = setUp();
    await settle();
    const first = advice.getState().announcement;
    expect(first).toMatchObject({ line: 1, kind: "delayed-about-front" });
    edit("left 90");
    await settle();
    edit("delayed left 90");
    await settle();
    expect(advice.getState().announcement).toBe(first);
  });

  it("remains hidden once it was hidden, even after an undo, and appears for another line", async () => {
    const { workspace, advice, settle, lines, edit } = setUp();
    await settle();
    const given = adviceOn(1, advice.getState());
    if (given !== null) advice.hide(given);
    expect(lines()).toEqual([]);
    edit("left 90");
    await settle();
    undo(workspace);
    await settle();
    expect(workspace.getState().program).toBe(wrong);
    expect(lines()).toEqual([]);
    applyEdit(workspace, setNumber(wrong, 1, 40));
    await settle();
    expect(lines()).toEqual([1]);
  });

  it("is taken in one step of the history", async () => {
    const { workspace, advice, settle, lines } = setUp();
    await settle();
    const fix = adviceOn(1, advice.getState())?.fix;
    const fixed = fix ? advice.fixedProgram(fix) : null;
    if (fix && fixed) setFixedProgram(workspace, fix, fixed);
    expect(workspace.getState().program.rules[1]?.do).toBe("left 90");
    expect(lines()).toEqual([]);
    undo(workspace);
    expect(workspace.getState().program).toBe(wrong);
  });

  it("is asked for again where the coach could not be loaded", async () => {
    let tries = 0;
    const { settle, lines, edit } = setUp(wrong, async () => {
      if (++tries === 1) throw new Error("no network");
      return coach;
    });
    await settle();
    expect(lines()).toEqual([]);
    edit("left 90");
    edit("delayed left 90");
    await settle();
    expect(lines()).toEqual([1]);
  });
});
