import type { Command } from "@corridor/protocol";
import { expect, it } from "vitest";
import { overtakingOf } from "./robot-commands.ts";

const stop: Command = { action: "stop" };
const turn: Command = { action: "left 90" };

it.each([
  { what: "a stop overtakes as a stop", command: stop, replace: false, how: "stop" },
  { what: "a stop that replaces overtakes as a stop", command: stop, replace: true, how: "stop" },
  { what: "a replacement overtakes", command: turn, replace: true, how: "replace" },
  { what: "any other command waits", command: turn, replace: false, how: null },
])("$what", ({ command, replace, how }) => {
  expect(overtakingOf(command, replace)).toBe(how);
});
