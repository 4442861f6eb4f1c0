/** The limits that a host must support, and its response when they are exceeded. */
import { commandRecordSchema, problemSchema, type Order } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { pause, waitForRetryAfter, type Host } from "../host.ts";
import { must, Mismatch, NeverTestable, validate } from "../mismatch.ts";

const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 60_000 } as const;
/** Waits until the queue is full, even if the network is slow. */
const WAITING_COMMAND = { ...BUSY, ttl: 60_000 } as const;
const WAITING = 64;
/**
 * Maximum number of commands before the queue is full. A relay can have some at the robot in
 * addition to its queue.
 */
const MOST = 100;
/** Commands at once, and commands a second, that a host must accept. */
const BURST = 40;
const RATE = 20;
/** Stops at once that a host must accept. */
const STOPS = 20;
/**
 * Maximum number of waits while the queue fills. A host that accepts 20 commands a second needs
 * four.
 */
const MAX_RETRIES = 20;
const LOG_PAGE = 200;
/** The protocol promises 10,000 records and 1,000 events. A run may produce fewer. */
const RETAINED_RECORDS = { min: 250, max: 10_000 };
const RETAINED_EVENTS = { min: 400, max: 1_000 };

export const limits: CheckGroup = {
  title: "Limits",
  checks: [
    {
      promise: "burst",
      name: "40 commands at once are accepted, and 20 more after a second",
      run: async (host) => {
        // Earlier commands can count toward a host's rate limit, so that the check waits first.
        await pause((BURST / RATE) * 1_000 + 500);
        for (const count of [BURST, RATE]) {
          await mustAcceptAtOnce(host, count, BUSY);
          await host.sendAndWait({ action: "stop" });
          await pause(1_100);
        }
      },
    },
    {
      promise: "stop-burst",
      name: "20 stops at once are accepted",
      run: async (host) => {
        await mustAcceptAtOnce(host, STOPS, { action: "stop" });
        const end = await host.sendAndWait({ action: "stop" });
        must(end.state === "completed", "completed", end);
      },
    },
    {
      promise: "stop-full",
      name: "a stop is accepted while the queue is full",
      run: async (host) => {
        await fill(host);
        const stop = { method: "POST", body: { action: "stop" } };
        const response = await host.requestOnce("/commands", stop);
        must(response.status === 202, "202 for a stop", `${response.status} ${response.text}`);
        const { seq } = validate(commandRecordSchema, response.json, "a command record");
        const end = await host.waitForEnd(seq);
        must(end.state === "completed", "completed", end);
      },
    },
    {
      promise: "queue",
      name: "at least 64 commands can wait; further ones are rejected with 429, and their keys stay free",
      run: async (host) => {
        try {
          const rejected = await fill(host);
          const { type } = validate(problemSchema, rejected.response.json, "a problem document");
          must(type.endsWith("/queue-full"), "the problem queue-full", type);
          const after = rejected.response.header("retry-after");
          must(/^\d+$/.test(after), "the header Retry-After in seconds", after || "none");
          must(rejected.accepted >= WAITING, `${WAITING} commands to wait`, rejected.accepted);
          await host.sendAndWait({ action: "stop" });
          const again = await host.send(BUSY, rejected.key);
          must(!again.duplicate, "a new command by the key that was rejected", again);
        } finally {
          await host.sendAndWait({ action: "stop" });
        }
      },
    },
    {
      promise: "log-page",
      name: "the log has pages of at most 200 records, without missing ones",
      run: async (host) => {
        const newest = await host.sendAndWait({ action: "stop" });
        let after = Math.max(0, newest.seq - LOG_PAGE - 20);
        const first = after;
        const seqs: number[] = [];
        while (after < newest.seq) {
          const response = (await host.log(after)) as { commands?: { seq: number }[] } | null;
          const numbers = response?.commands?.map(({ seq }) => seq) ?? [];
          must(numbers.length <= LOG_PAGE, "at most 200 records", numbers.length);
          must(numbers.length > 0, `records after ${after}`, "none");
          seqs.push(...numbers);
          after = numbers.at(-1) ?? newest.seq;
        }
        const isWhole = seqs.every((seq, index) => seq === first + index + 1);
        must(isWhole, "every number once", seqs.join());
        must(seqs.length > LOG_PAGE, "more than one page", `${seqs.length} records`);
      },
    },
    {
      promise: "records-retained",
      name: "the oldest record of the run can still be read",
      run: async (host) => {
        const newest = await host.sendAndWait({ action: "stop" });
        const oldest = Math.max(1, newest.seq - RETAINED_RECORDS.max + 1);
        must(newest.seq >= RETAINED_RECORDS.min, `${RETAINED_RECORDS.min} commands`, newest.seq);
        const { seq } = await host.record(oldest);
        must(seq === oldest, `the record ${oldest}`, seq);
      },
    },
    {
      promise: "events-retained",
      name: "events are retained: a reader that missed hundreds of them receives all",
      run: async (host) => {
        const newest = await eventsSince(host, null);
        const [stream = "", n = "0"] = newest.since.split("-");
        must(Number(n) >= RETAINED_EVENTS.min, `${RETAINED_EVENTS.min} events of this run`, n);
        const retained = Math.min(Number(n), RETAINED_EVENTS.max);
        const { gap, states } = await eventsSince(host, `${stream}-${Number(n) - retained}`);
        must(gap === null, `no gap after the newest ${retained}`, gap);
        must(states.length >= retained, `${retained} states`, states.length);
      },
    },
    {
      promise: "events-time",
      name: "events are retained for 10 minutes",
      run: async () => {
        throw new NeverTestable("a run is shorter than 10 minutes");
      },
    },
  ],
};

async function mustAcceptAtOnce(host: Host, count: number, body: Order): Promise<void> {
  const post = async () => host.requestOnce("/commands", { method: "POST", body });
  const responses = await Promise.all(Array.from({ length: count }, post));
  const rejected = responses.filter(({ status }) => status !== 202);
  must(rejected.length === 0, `${count} responses of 202`, rejected.map(({ text }) => text)[0]);
}

/** Sends commands until the queue is full. */
async function fill(host: Host) {
  await host.send(WAITING_COMMAND);
  let retryCount = 0;
  for (let accepted = 0; accepted < MOST;) {
    const key = host.newKey();
    const options = { method: "POST", body: WAITING_COMMAND, headers: { "Idempotency-Key": key } };
    const response = await host.requestOnce("/commands", options);
    if (response.status === 202) accepted += 1;
    else if (isRateLimited(response.json) && retryCount < MAX_RETRIES) {
      retryCount += 1;
      await waitForRetryAfter(response);
    } else {
      must(response.status === 429, "202 or 429", `${response.status} ${response.text}`);
      return { accepted, key, response };
    }
  }
  throw new Mismatch(`429 for one of ${MOST} commands that wait`, "202 for each");
}

function isRateLimited(problem: unknown): boolean {
  return (problem as { type?: string } | null)?.type?.endsWith("/too-fast") === true;
}

async function eventsSince(host: Host, since: string | null) {
  const query = since === null ? "" : `&since=${since}`;
  const response = await host.request(`/events?wait=0${query}`);
  must(response.status === 200, "200 for /events", `${response.status} ${response.text}`);
  return response.json as { since: string; gap: unknown; states: unknown[] };
}
