import { join } from "node:path";
import type { SQLOutputValue } from "node:sqlite";
import { commandRecordSchema, hasEnded } from "@corridor/protocol";
import { expect, it, onTestFinished } from "vitest";
import { rowOf, STOP } from "../../../commands/testing/robot-with.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import { entryOf, rowIn } from "./journal.ts";
import { openDatabase } from "./sqlite-schema.ts";

/** The columns of a row in the table of commands. */
function columnsOf(entry: string): Record<string, SQLOutputValue> | undefined {
  const db = openDatabase(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => db.close());
  db.exec("INSERT INTO sessions (id, created_at, last_used_at) VALUES ('a', 1, 1)");
  db.prepare("INSERT INTO commands (robot, entry) VALUES ('a', ?)").run(entry);
  return db.prepare("SELECT overtakes, is_open FROM commands").get();
}

it.each(commandRecordSchema.shape.state.options)(
  "a query finds a %s command by whether it is open",
  (state) => {
    expect(columnsOf(entryOf(rowOf({ state }), 0))).toMatchObject({
      is_open: hasEnded(state) ? 0 : 1,
    });
  },
);

it.each([
  { what: "a stop", row: { text: STOP }, overtakes: "stop" },
  { what: "a stop that replaces", row: { text: STOP, replace: true }, overtakes: "stop" },
  { what: "a replacement", row: { replace: true }, overtakes: "replace" },
  { what: "a command that waits", row: {}, overtakes: null },
])("a query finds $what by how it overtakes", ({ row, overtakes }) => {
  expect(columnsOf(entryOf(rowOf(row), 0))).toMatchObject({ overtakes });
});

it("restores the row", () => {
  const row = rowOf({ state: "completed", pose: { x: 1, y: 2, heading: 90 }, distance: 4 });
  for (const each of [row, rowOf({ text: STOP }), rowOf({ replace: true, lease: 500 })])
    expect(rowIn(entryOf(each, 7))).toEqual({ row: each, deletedTo: 7 });
});
