/** The limits that a host must support, and its response when they are exceeded. */
import { commandRecordSchema, problemSchema, type Order } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { pause, pauseForRetryAfter, type Host } from "../host.ts";
import { must, Mismatch, NeverTestable, shaped } from "../mismatch.ts";

const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 60_000 } as const;
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
const MOST_PAUSES = 20;
const LOG_PAGE = 200;
/** The protocol promises 10,000 records and 1,000 events. A run may produce fewer. */
const RETAINED_RECORDS = { min: 250, max: 10_000 };
const RETAINED_EVENTS = { min: 400, max: 1_000 };

export const limits: CheckGroup = {
  title: "Limits",
  checks: [
    {
      promise: "burst",
      name: "40 commands at once are taken, and 20 more after a second",
      run: async (host) => {
        // Earlier commands can count toward a host's rate limit, so that the check waits first.
        await pause((BURST / RATE) * 1_000 + 500);
        for (const count of [BURST, RATE]) {
          await mustTakeAtOnce(host, count, BUSY);
          await host.done({ action: "stop" });
          await pause(1_100);
        }
      },
    },
    {
      promise: "stop-burst",
      name: "20 stops at once are taken",
      run: async (host) => {
        await mustTakeAtOnce(host, STOPS, { action: "stop" });
        const end = await host.done({ action: "stop" });
        must(end.state === "completed", "completed", end);
      },
    },
    {
      promise: "stop-full",
      name: "a stop is taken while the queue is full",
      run: async (host) => {
        await fill(host);
        const stop = { method: "POST", body: { action: "stop" } };
        const answer = await host.askOnce("/commands", stop);
        must(answer.status === 202, "202 for a stop", `${answer.status} ${answer.text}`);
        const { seq } = shaped(commandRecordSchema, answer.json, "a command record");
        const end = await host.ended(seq);
        must(end.state === "completed", "completed", end);
      },
    },
    {
      promise: "queue",
      name: "at least 64 commands may wait; one too many is refused with 429 and its key stays free",
      run: async (host) => {
        try {
          const refused = await fill(host);
          const { type } = shaped(problemSchema, refused.answer.json, "a problem document");
          must(type.endsWith("/queue-full"), "the problem queue-full", type);
          const after = refused.answer.header("retry-after");
          must(/^\d+$/.test(after), "the header Retry-After in seconds", after || "none");
          must(refused.taken >= WAITING, `${WAITING} commands to wait`, refused.taken);
          await host.done({ action: "stop" });
          const again = await host.send(BUSY, refused.key);
          must(!again.duplicate, "a new command by the key that was refused", again);
        } finally {
          await host.done({ action: "stop" });
        }
      },
    },
    {
      promise: "log-page",
      name: "the log comes in pages of at most 200 records, without a hole",
      run: async (host) => {
        const newest = await host.done({ action: "stop" });
        let after = Math.max(0, newest.seq - LOG_PAGE - 20);
        const first = after;
        const seqs: number[] = [];
        while (after < newest.seq) {
          const answer = (await host.log(after)) as { commands?: { seq: number }[] } | null;
          const numbers = answer?.commands?.map(({ seq }) => seq) ?? [];
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
        const newest = await host.done({ action: "stop" });
        const oldest = Math.max(1, newest.seq - RETAINED_RECORDS.max + 1);
        must(newest.seq >= RETAINED_RECORDS.min, `${RETAINED_RECORDS.min} commands`, newest.seq);
        const { seq } = await host.record(oldest);
        must(seq === oldest, `the record ${oldest}`, seq);
      },
    },
    {
      promise: "events-kept",
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

async function mustTakeAtOnce(host: Host, count: number, body: Order): Promise<void> {
  const post = async () => host.askOnce("/commands", { method: "POST", body });
  const answers = await Promise.all(Array.from({ length: count }, post));
  const refused = answers.filter(({ status }) => status !== 202);
  must(refused.length === 0, `${count} answers of 202`, refused.map(({ text }) => text)[0]);
}

/** Sends commands until the queue is full. */
async function fill(host: Host) {
  await host.send(BUSY);
  let pauses = 0;
  for (let taken = 0; taken < MOST;) {
    const key = host.newKey();
    const options = { method: "POST", body: BUSY, headers: { "Idempotency-Key": key } };
    const answer = await host.askOnce("/commands", options);
    if (answer.status === 202) taken += 1;
    else if (isTooFast(answer.json) && pauses < MOST_PAUSES) {
      pauses += 1;
      await pauseForRetryAfter(answer);
    } else {
      must(answer.status === 429, "202 or 429", `${answer.status} ${answer.text}`);
      return { taken, key, answer };
    }
  }
  throw new Mismatch(`429 for one of ${MOST} commands that wait`, "202 for each");
}

function isTooFast(problem: unknown): boolean {
  return (problem as { type?: string } | null)?.type?.endsWith("/too-fast") === true;
}

async function eventsSince(host: Host, since: string | null) {
  const query = since === null ? "" : `&since=${since}`;
  const answer = await host.ask(`/events?wait=0${query}`);
  must(answer.status === 200, "200 for /events", `${answer.status} ${answer.text}`);
  return answer.json as { since: string; gap: unknown; states: unknown[] };
}
