import { mazePresets } from "@corridor/maze";
import { emptyProgram } from "@corridor/program";
import type { DriverName } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { addLine } from "../workspace/program-actions.ts";
import { createScreenStore } from "../screen/screen-store.ts";
import { createWorkspaceStore, setProgram, undo } from "../workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { chooseMaze } from "./choose-preset.ts";

const spiral = mazePresets.find(({ id }) => id === "spiral")?.maze;
if (spiral === undefined) throw new Error("a preset is gone");
const chosen = spiral;
const mine = { ...firstProgram, name: "Mine" };

function choose(
  program: typeof firstProgram,
  nowDriver: DriverName = "program",
  maze: typeof chosen = chosen,
) {
  const workspace = createWorkspaceStore(firstMaze, program);
  const screen = createScreenStore();
  const sent: string[] = [];
  const simulator = { send: (message: { type: string }) => sent.push(message.type) };
  const run = { getState: () => ({ nowDriver }) };
  const services = { workspace, screen, simulator, run } as unknown as Parameters<
    typeof chooseMaze
  >[0];
  chooseMaze(services, createI18n(en), maze);
  const message = screen.getState().messages[0];
  return { workspace, sent, text: message?.text, undo: () => message?.action?.run() };
}

describe("choosing a maze", () => {
  it("opens with an empty program in place of the example, and shows the goal", () => {
    const { workspace, sent, text } = choose(firstProgram);
    expect(workspace.getState()).toMatchObject({
      maze: chosen,
      program: emptyProgram(),
      lineIds: [],
    });
    expect(text).toBe("“Spiral” is open. Your program is empty: get the robot to the goal.");
    expect(sent).toEqual(["reset"]);
  });

  it("shows the goal without the program while Remote drives", () => {
    expect(choose(firstProgram, "remote").text).toBe(
      "“Spiral” is open. Get the robot to the goal.",
    );
  });

  it.each(["program", "remote"] as const)(
    "asks for no goal in a maze without one, with the driver %s",
    (driver) => {
      expect(choose(firstProgram, driver, { ...chosen, goals: [] }).text).toBe(
        "“Spiral” is open. It has no goal yet: set one, or explore.",
      );
    },
  );

  it("leaves one message when another maze is chosen at once, and Undo goes back one maze", () => {
    const workspace = createWorkspaceStore(firstMaze, firstProgram);
    const screen = createScreenStore();
    const simulator = { send: () => undefined };
    const run = { getState: () => ({ nowDriver: null }) };
    const services = { workspace, screen, simulator, run } as unknown as Parameters<
      typeof chooseMaze
    >[0];
    chooseMaze(services, createI18n(en), chosen);
    chooseMaze(services, createI18n(en), { ...chosen, name: "Another" });
    const { messages } = screen.getState();
    expect(messages.map(({ text }) => text)).toEqual([
      "“Another” is open. Your program is empty: get the robot to the goal.",
    ]);
    messages[0]?.action?.run();
    expect(workspace.getState().maze).toBe(chosen);
  });

  it("leaves no message once Undo outside of the message brought the old maze back", () => {
    const workspace = createWorkspaceStore(firstMaze, firstProgram);
    const screen = createScreenStore();
    const simulator = { send: () => undefined };
    const run = { getState: () => ({ nowDriver: null }) };
    chooseMaze({ workspace, screen, simulator, run } as never, createI18n(en), chosen);
    setProgram(workspace, mine);
    expect(screen.getState().messages).toHaveLength(1);
    undo(workspace);
    undo(workspace);
    expect(screen.getState().messages).toEqual([]);
  });

  it("leaves a program that the student has written", () => {
    const { workspace, text } = choose(mine);
    expect(workspace.getState()).toMatchObject({ maze: chosen, program: mine });
    expect(text).toBe("“Spiral” is open. Your program did not change.");
  });

  it("is one step of the history", () => {
    const { workspace } = choose(firstProgram);
    undo(workspace);
    expect(workspace.getState()).toMatchObject({ maze: firstMaze, program: firstProgram });
  });

  it("is reverted with its program by the message", () => {
    const { workspace, undo } = choose(firstProgram);
    undo();
    expect(workspace.getState()).toMatchObject({ maze: firstMaze, program: firstProgram });
  });

  it("is reverted, and lines written since then remain", () => {
    const { workspace, undo } = choose(firstProgram);
    addLine(workspace);
    undo();
    expect(workspace.getState().maze).toBe(firstMaze);
    expect(workspace.getState().program.rules).toHaveLength(1);
  });
});
