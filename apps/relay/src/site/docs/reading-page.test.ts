/** The events in /docs/reading, parsed as a script parses them. */
import { commandRecordSchema, eventGapSchema, snapshotSchema } from "@corridor/protocol";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { z } from "zod";

const text = readFileSync(join(import.meta.dirname, "pages/reading.md"), "utf8");

/** Schema of `data` by event. */
const shapes: Record<string, z.ZodType> = {
  snapshot: snapshotSchema,
  state: commandRecordSchema,
  gap: eventGapSchema,
  maze: z.strictObject({ version: z.string() }),
};

it("the page about reading shows one event of each kind, as the stream sends it", () => {
  const [, block = ""] = /```text\n(event: snapshot[^]*?)```/.exec(text) ?? [];
  const kinds = [];
  for (const event of block.trim().split("\n\n")) {
    const [, kind = "", data = ""] = /^(?:id: .*\n)?event: (.*)\ndata: (.*)$/.exec(event) ?? [];
    const value: unknown = JSON.parse(data);
    expect(shapes[kind]?.parse(value)).toEqual(value);
    kinds.push(kind);
  }
  expect(kinds).toEqual(Object.keys(shapes));
});
