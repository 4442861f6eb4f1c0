import { emptyProgram } from "@corridor/program";
import { expect, it } from "vitest";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { isExample } from "../../model/workspace/example.ts";
import { writeOwn } from "./write-own.ts";

it("recognizes the example in every language, and no other program", () => {
  expect(isExample(firstProgram)).toBe(true);
  expect(isExample({ ...firstProgram, name: "例：右の壁" })).toBe(true);
  expect(isExample({ ...firstProgram, name: "" })).toBe(false);
  expect(isExample({ ...firstProgram, default: "reverse" })).toBe(false);
  expect(isExample(emptyProgram())).toBe(false);
});

it("makes an empty program, moves the robot to its start, shows the goal, and undo reverts it", () => {
  const workspace = createWorkspaceStore(firstMaze, firstProgram);
  const screen = createScreenStore();
  const sent: string[] = [];
  const simulator = { send: (message: { type: string }) => sent.push(message.type) };
  const services = { workspace, screen, simulator } as unknown as Parameters<typeof writeOwn>[0];
  writeOwn(services, createI18n(en));
  expect(workspace.getState()).toMatchObject({
    maze: firstMaze,
    program: emptyProgram(),
    lineIds: [],
  });
  expect(sent).toEqual(["reset"]);
  const [message] = screen.getState().messages;
  expect(message?.text).toBe("Your program is empty now. Get the robot to the goal.");
  message?.action?.run();
  expect(workspace.getState().program).toEqual(firstProgram);
  expect(screen.getState().messages).toEqual([]);
});

it("asks for no goal in a maze without one", () => {
  const workspace = createWorkspaceStore({ ...firstMaze, goals: [] }, firstProgram);
  const screen = createScreenStore();
  const simulator = { send: () => undefined };
  const services = { workspace, screen, simulator } as unknown as Parameters<typeof writeOwn>[0];
  writeOwn(services, createI18n(en));
  expect(screen.getState().messages[0]?.text).toBe("Your program is empty now.");
});
