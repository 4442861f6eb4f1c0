/** The events that /docs/http shows, read as a script reads them. */
import { commandRecordSchema, eventGapSchema, snapshotSchema } from "@corridor/protocol";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { z } from "zod";

const text = readFileSync(join(import.meta.dirname, "pages/http.md"), "utf8");

/** What the stream sends as `data` of each event. */
const shapes: Record<string, z.ZodType> = {
  snapshot: snapshotSchema,
  state: commandRecordSchema,
  gap: eventGapSchema,
  maze: z.strictObject({ version: z.string() }),
};

it("the page about HTTP shows one event of each kind, as the stream sends it", () => {
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
