/** Events: server-sent and by long poll, resumed without loss or with a reported gap. */
import { eventPageSchema, hasEnded, type CommandState, type StateEvent } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { EventStream, withEvents } from "../event-stream.ts";
import { pause, type Host } from "../host.ts";
import { must, validate } from "../mismatch.ts";

const EVENTS_MS = 15_000;
const STREAM_MS = 2_000;
/** Maximum number of snapshots in that time; the protocol allows 20 a second. */
const MAX_SNAPSHOTS = 60;
const MANY = 6;

export const events: CheckGroup = {
  title: "Events",
  checks: [
    {
      promise: "stream",
      name: "server-sent events contain snapshots and the states of commands",
      run: async (host) => {
        await withEvents(host, async (stream) => {
          await stream.until(() => stream.snapshots[0], EVENTS_MS, "a snapshot");
          const { seq } = await host.send({ action: "left 90" });
          const { record } = await stream.ended(seq, EVENTS_MS);
          must(record.state === "completed", "completed", record);
        });
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "stream-pace",
      name: "a reader receives at most 20 snapshots a second",
      run: async (host) => {
        await withEvents(host, async (stream) => {
          await host.send({ action: "drive", left: 0, right: 0, milliseconds: STREAM_MS + 500 });
          await stream.until(() => stream.snapshots[0], EVENTS_MS, "a snapshot");
          const before = stream.snapshots.length;
          await pause(STREAM_MS);
          const count = stream.snapshots.length - before;
          must(count <= MAX_SNAPSHOTS, "about 40 snapshots in 2 s", count);
        });
        await host.sendAndWait({ action: "stop" });
      },
    },
    {
      promise: "stream-resume",
      name: "Last-Event-ID resumes a stream: each missed event arrives once",
      run: async (host) => {
        const first = await EventStream.open(host);
        const turn = await host.send({ action: "left 90" });
        await first.ended(turn.seq, EVENTS_MS);
        const since = first.lastId;
        first.close();
        const { seq } = await host.sendAndWait({ action: "right 90" });
        const second = await EventStream.open(host, since);
        try {
          await second.ended(seq, EVENTS_MS);
          const seqs = new Set(second.states.map(({ record }) => record.seq));
          must(!seqs.has(turn.seq), "no earlier states", [...seqs]);
          const { record } = second.states[0] ?? {};
          must(record?.state !== "completed", "every state of the missed command", record);
        } finally {
          second.close();
        }
      },
    },
    {
      promise: "poll",
      name: "events by long poll resume where the previous response ended",
      run: async (host) => {
        const first = await page(host, "?wait=0");
        must(first.states.length === 0, "no states without since", first.states.length);
        const { seq } = await host.sendAndWait({ action: "left 90" });
        const next = await page(host, `?wait=5&since=${first.since}`);
        must(next.gap === null, "no gap", next.gap);
        const states = next.states.filter(({ record }) => record.seq === seq);
        must(states.at(-1)?.record.state === "completed", "all states until completed", states);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "poll-once",
      name: "no event is sent twice, and a poll waits for a new event",
      run: async (host) => {
        const { since } = await page(host, "?wait=0");
        await host.sendAndWait({ action: "left 90" });
        const next = await page(host, `?wait=5&since=${since}`);
        const startedAt = performance.now();
        const last = await page(host, `?wait=0.5&since=${next.since}`);
        must(last.states.length === 0, "no states twice", last.states);
        const waited = performance.now() - startedAt;
        must(waited > 400, "a response after 0.5 s", `${Math.round(waited)} ms`);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "poll-snapshot",
      name: "with `after`, a poll responds when there is a newer snapshot, and contains it",
      run: async (host) => {
        const { since } = await page(host, "?wait=0");
        const { seq } = await host.snapshot();
        const startedAt = performance.now();
        const { snapshot } = await page(host, `?wait=20&since=${since}&after=${seq}`);
        const waited = performance.now() - startedAt;
        must(snapshot !== null && snapshot.seq > seq, `a snapshot above ${seq}`, snapshot?.seq);
        must(waited < EVENTS_MS, "a response with the next snapshot", `${Math.round(waited)} ms`);
      },
    },
    {
      promise: "resume",
      name: "a disconnected reader resumes: events in order, with one final state per command",
      run: async (host) => {
        const { since } = await page(host, "?wait=0");
        const seqs: number[] = [];
        for (let n = 0; n < MANY; n++) {
          seqs.push((await host.sendAndWait({ action: n % 2 === 0 ? "left 90" : "right 90" })).seq);
        }
        const { gap, states } = await page(host, `?wait=5&since=${since}`);
        must(gap === null, "no gap", gap);
        const first = states[0]?.n ?? 0;
        const isWhole = states.every(({ n }, index) => n === first + index);
        must(isWhole, "numbers that increase by one", states.map(({ n }) => n).join());
        for (const seq of seqs) mustFollowLifeCycle(states, seq);
      },
    },
    {
      promise: "gap",
      name: "a reader of another stream, or with a future number, receives a gap with the open commands",
      run: async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 5_000,
        });
        const { since } = await page(host, "?wait=0");
        const stream = since.split("-")[0] ?? "";
        for (const lost of ["zzzzzzzz-1", `${stream}-900000000`]) {
          const { gap, states } = await page(host, `?wait=0&since=${lost}`);
          must(gap !== null, `a gap after ${lost}`, gap);
          must(states.length === 0, "no states with a gap", states);
          const open = gap.open.map((each) => each.seq);
          must(open.includes(seq), `command ${seq} among the open ones`, open);
        }
        await host.sendAndWait({ action: "stop" });
      },
    },
    {
      promise: "gap-stream",
      name: "a stream that cannot resume starts with a gap",
      run: async (host) => {
        const stream = await EventStream.open(host, "zzzzzzzz-1");
        try {
          await stream.until(() => stream.gaps[0], EVENTS_MS, "an event gap");
        } finally {
          stream.close();
        }
      },
    },
  ],
};

/** The states of one command follow the protocol's order, with exactly one final state. */
export function mustFollowLifeCycle(states: readonly StateEvent[], seq: number): void {
  const life = states.filter(({ record }) => record.seq === seq).map(({ record }) => record.state);
  const endings = life.filter((state) => hasEnded(state));
  must(endings.length === 1, `one ending of command ${seq}`, life);
  const order: CommandState[] = ["accepted", "delivered", "started", ...endings];
  const isInOrder = life.every(
    (state, n) => order.indexOf(state) >= order.indexOf(life[n - 1] ?? state),
  );
  must(isInOrder && life.includes("started"), `started, then its ending, of command ${seq}`, life);
}

async function page(host: Host, query: string) {
  const response = await host.request(`/events${query}`);
  must(response.status === 200, `200 for /events${query}`, `${response.status} ${response.text}`);
  return validate(eventPageSchema, response.json, "a response of events");
}
