import { expect, it } from "vitest";
import type { z } from "zod";
import type { oas31 } from "zod-openapi";
import { snapshotOf } from "@corridor/protocol/testing";
import { DescribedRelay } from "../../testing/described-relay.ts";
import { maze } from "../../platform/testing/sample-documents.ts";
import { TestSocket } from "../../testing/test-socket.ts";

/** Parses the events of a stream. */
async function* eventsOf(answer: Response): AsyncGenerator<Record<string, string>> {
  let text = "";
  for await (const part of (answer.body ?? new ReadableStream()).pipeThrough(
    new TextDecoderStream(),
  )) {
    text += part;
    const blocks = text.split("\n\n");
    text = blocks.pop() ?? "";
    for (const block of blocks) {
      const lines = block.split("\n").map((line) => line.split(/: (.*)/s));
      const event = Object.fromEntries(lines.filter(([field]) => field !== ""));
      if ("event" in event) yield event;
    }
  }
}

/** Described schema of the `data` of an event. */
function shapeOfData(api: DescribedRelay, event: string): z.ZodType {
  const name = `${event[0]?.toUpperCase()}${event.slice(1)}Event`;
  const described = api.document.components?.schemas?.[name] as {
    properties: { data: { contentSchema: oas31.SchemaObject } };
  };
  const schema = described.properties.data.contentSchema;
  return api.schemaOf({ description: "", content: { data: { schema } } });
}

it("describes the event stream as it is, each event and its data", async () => {
  const api = await DescribedRelay.start();
  const { robot, relay } = api;
  const { socket: page, epoch } = await TestSocket.page(relay, robot);
  page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
  const ended = new AbortController();
  const stream = await relay.ask(robot, "/events?since=AAAAAAAA-1", { signal: ended.signal });
  const { content = {} } = api.answerOf("get", "/api/v1/robots/{id}/events", 200);
  const described = { description: "", content: { stream: content["text/event-stream"] ?? {} } };
  const schema = api.schemaOf(described);
  const wanted = new Set(["snapshot", "state", "gap", "maze"]);
  await relay.ask(robot, "/maze", { method: "PUT", key: robot.ownerKey, body: maze });
  await relay.ask(robot, "/commands", { method: "POST", body: { action: "stop" } });
  for await (const event of eventsOf(stream)) {
    expect(schema.safeParse(event).error).toBeUndefined();
    const data: unknown = JSON.parse(event["data"] ?? "");
    expect(shapeOfData(api, event["event"] ?? "").safeParse(data).error).toBeUndefined();
    wanted.delete(event["event"] ?? "");
    if (wanted.size === 0) break;
  }
  ended.abort();
  expect([...wanted]).toEqual([]);
});
