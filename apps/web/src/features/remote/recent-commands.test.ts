import type { CommandState } from "@corridor/protocol";
import { expect, it } from "vitest";
import type { ListedCommand } from "../../simulator/protocol/worker-messages.ts";
import { recentCommands } from "./recent-commands.ts";

const list = (...states: CommandState[]) =>
  states.map((state, index) => ({ seq: states.length - index, state }) as ListedCommand);
const seqs = ({ listed }: ReturnType<typeof recentCommands>) => listed.map(({ seq }) => seq);

it("lists the running command and the last five that ended, however many wait", () => {
  const waiting: CommandState[] = Array.from({ length: 60 }, () => "accepted");
  const recent = recentCommands(
    list(
      ...waiting,
      "delivered",
      "started",
      "completed",
      "collided",
      "expired",
      "cancelled",
      "superseded",
      "completed",
      "completed",
    ),
  );
  expect(seqs(recent)).toEqual([8, 7, 6, 5, 4, 3]);
  expect(recent.waiting).toBe(61);
});

it("lists the last five where none runs, and no more than there are", () => {
  expect(
    seqs(recentCommands(list(...Array.from({ length: 9 }, () => "completed" as const)))),
  ).toEqual([9, 8, 7, 6, 5]);
  expect(recentCommands([])).toEqual({ listed: [], waiting: 0 });
});

it("lists the one that is selected on the timeline as well, however old it is", () => {
  const nine = list(...Array.from({ length: 9 }, () => "completed" as const));
  expect(seqs(recentCommands(nine, 2))).toEqual([9, 8, 7, 6, 5, 2]);
});
