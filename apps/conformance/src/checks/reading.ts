/** Reading: sensors, events, the log. */
import {
  commandRecordSchema,
  eventPageSchema,
  problemSchema,
  snapshotSchema,
} from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import type { Host } from "../host.ts";
import { must, Mismatch, shaped } from "../mismatch.ts";

/** Robots report at least once a second, also while they stand. */
const REPORT_MS = 5_000;
const EVENTS_MS = 15_000;

export const reading: CheckGroup = {
  title: "Sensors, events, log",
  checks: [
    {
      name: "a reading is a whole snapshot",
      run: async (host) => {
        const answer = await host.ask("/sensors?wait=10");
        must(answer.status === 200, "200", `${answer.status} ${answer.text}`);
        shaped(snapshotSchema, answer.json, "a snapshot");
      },
    },
    {
      name: "a reading after a command is never from before its end",
      run: async (host) => {
        for (let n = 0; n < 4; n++) {
          const turn = await host.done({ action: "right 90" });
          const { pose } = await host.snapshot("");
          const apart = Math.abs(pose.heading - (turn.pose?.heading ?? -1));
          must(apart < 2 || apart > 358, `the heading ${turn.pose?.heading}`, pose.heading);
        }
      },
    },
    {
      name: "a reading with after waits for a newer one",
      run: async (host) => {
        const first = await host.snapshot();
        const began = performance.now();
        const next = await host.snapshot(`?after=${first.seq}&wait=10`);
        const waited = performance.now() - began;
        must(next.seq > first.seq, `a seq above ${first.seq}`, next.seq);
        must(waited < REPORT_MS, "a report every second", `${Math.round(waited)} ms`);
      },
    },
    {
      name: "a reading that has nothing newer answers when its time is over",
      run: async (host) => {
        const began = performance.now();
        await host.snapshot("?after=900000000000000&wait=0.3");
        const waited = performance.now() - began;
        must(waited < 5_000, "an answer after 0.3 s", `${Math.round(waited)} ms`);
      },
    },
    {
      name: "a host that knows its maze tells it by a version, and one that does not says so",
      run: async (host) => {
        const answer = await host.ask("/maze");
        if (answer.status === 404) {
          shaped(problemSchema, answer.json, "a problem document");
          return;
        }
        must(answer.status === 200, "200 or 404 for the maze", `${answer.status} ${answer.text}`);
        const format = (answer.json as { format?: unknown } | null)?.format;
        must(format === "corridor/maze", 'the format "corridor/maze"', format);
        const tag = answer.header("etag");
        must(tag !== "", "an ETag", "none");
        const again = await host.ask("/maze", { headers: { "If-None-Match": tag } });
        must(again.status === 304, "304 for a maze that is known", again.status);
      },
    },
    {
      name: "server-sent events tell snapshots and what becomes of commands",
      run: streamTells,
    },
    {
      name: "events by long poll go on from where the last answer ended",
      run: async (host) => {
        const first = await eventPage(host, "?wait=0");
        must(first.states.length === 0, "no states without since", first.states.length);
        const { seq } = await host.done({ action: "left 90" });
        const next = await eventPage(host, `?wait=5&since=${first.since}`);
        must(next.gap === null, "no gap", next.gap);
        const states = next.states
          .filter(({ record }) => record.seq === seq)
          .map(({ record }) => record.state);
        must(states.at(-1) === "completed", "the states up to completed", states);
        const last = await eventPage(host, `?wait=0&since=${next.since}`);
        must(last.states.length === 0, "nothing twice", last.states);
      },
    },
    {
      name: "the log gives whole records in order, from where it is asked",
      run: async (host) => {
        const { seq } = await host.done({ action: "left 90" });
        await host.done({ action: "right 90" });
        const records = recordsIn(await host.log(seq - 1));
        const numbers = records.map((record) => record.seq);
        must(numbers.join() === [seq, seq + 1].join(), `${seq},${seq + 1}`, numbers);
        const none = recordsIn(await host.log(seq + 1));
        must(none.length === 0, "nothing after the last one", none.length);
      },
    },
  ],
};

async function eventPage(host: Host, query: string) {
  const answer = await host.ask(`/events${query}`);
  must(answer.status === 200, `200 for /events${query}`, `${answer.status} ${answer.text}`);
  return shaped(eventPageSchema, answer.json, "an answer of events");
}

function recordsIn(log: unknown) {
  const list = typeof log === "object" && log !== null && "commands" in log ? log.commands : null;
  must(Array.isArray(list) && list.length <= 200, '{"commands": [...]}, at most 200', log);
  return list.map((record) => shaped(commandRecordSchema, record, "a command record"));
}

async function streamTells(host: Host): Promise<void> {
  const controller = new AbortController();
  const timer = setTimeout(() => controller.abort(), EVENTS_MS);
  try {
    const response = await host.open("/events", controller.signal);
    const type = response.headers.get("content-type") ?? "none";
    must(type.startsWith("text/event-stream"), "Content-Type: text/event-stream", type);
    let isAsked = false;
    let seq = -1;
    for await (const { event, data } of eventsIn(response)) {
      if (event === "snapshot") {
        shaped(snapshotSchema, data, "a snapshot");
        if (isAsked) continue;
        isAsked = true;
        ({ seq } = await host.send({ action: "left 90" }));
      } else if (event === "state") {
        const record = shaped(commandRecordSchema, data, "a command record");
        if (record.seq === seq && record.state === "completed") return;
      }
    }
    throw new Mismatch("a stream that goes on", "its end");
  } catch (error) {
    if (!controller.signal.aborted) throw error;
    throw new Mismatch(
      `event: snapshot, and event: state up to completed, within ${EVENTS_MS / 1000} s`,
      "less than that",
    );
  } finally {
    clearTimeout(timer);
    controller.abort();
  }
}

async function* eventsIn(response: Response): AsyncGenerator<{ event: string; data: unknown }> {
  let text = "";
  for await (const chunk of response.body?.pipeThrough(new TextDecoderStream()) ?? []) {
    text += chunk;
    const blocks = text.split("\n\n");
    text = blocks.pop() ?? "";
    for (const block of blocks) {
      const event = /^event: ?(.*)$/m.exec(block)?.[1];
      const data = /^data: ?(.*)$/m.exec(block)?.[1];
      if (event !== undefined && data !== undefined) yield { event, data: JSON.parse(data) };
    }
  }
}
