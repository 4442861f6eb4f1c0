/**
 * Schema of one event of the stream at `/events`. The description of a stream describes its events.
 */
import { mazeVersionSchema, sinceSchema } from "@corridor/protocol";
import { z } from "zod";
import { createSchema } from "zod-openapi";

/** The field `data`, which contains JSON of another schema. */
const json = (description: string, contentSchema: object) =>
  z.string().meta({ description, contentMediaType: "application/json", contentSchema });

const dataOf = (shape: string) => json(`JSON: ${shape}`, { $ref: `#/components/schemas/${shape}` });

const mazeChanged = createSchema(z.strictObject({ version: mazeVersionSchema })).schema;

const id = sinceSchema.meta({ description: "send it as `Last-Event-ID` or `since`" });

export const streamedEventSchema = z.discriminatedUnion("event", [
  z.strictObject({ event: z.literal("snapshot"), data: dataOf("Snapshot") }),
  z.strictObject({ event: z.literal("state"), id, data: dataOf("CommandRecord") }),
  z.strictObject({ event: z.literal("gap"), id, data: dataOf("Gap") }),
  z.strictObject({ event: z.literal("maze"), data: json("JSON: the new version", mazeChanged) }),
]);
