/** A host executes a repeated command once, and never after its ttl. */
import { commandRecordSchema, problemSchema, type Order } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import type { Host } from "../host.ts";
import { must, validate } from "../mismatch.ts";
import { moveToStart, START_READINGS, mustHaveReadings } from "../pen.ts";

/** additional transit time of a command in ms */
const DELAY_MS = 1_500;
const DEFAULT_TTL_MS = 10_000;
/** A slow network delays both ends of a wait. */
const DEFAULT_TTL_TOLERANCE_MS = 2_500;

export const retries: CheckGroup = {
  title: "Retries, keys and ages",
  checks: [
    {
      promise: "retry",
      name: "a retry with the same key is the same command",
      run: async (host) => {
        const key = host.newKey();
        const first = await host.send({ action: "left 90" }, key);
        must(first.key === key, `the key ${key} in the record`, first.key);
        const again = await host.send({ action: "left 90", age: 200 }, key);
        must(again.seq === first.seq, `the record ${first.seq} again`, again.seq);
        must(again.duplicate, "duplicate: true", again.duplicate);
        const end = await host.waitForEnd(first.seq);
        const late = await host.send({ action: "left 90", age: 60_000 }, key);
        must(late.seq === first.seq && late.state === end.state, "the same record later", late);
        const other = await host.send({ action: "left 90", ttl: 20_000 }, key);
        must(other.seq === first.seq, "the same record with another ttl", other);
        const replacing = await host.send({ action: "left 90", replace: true }, key);
        must(replacing.seq === first.seq, "the same record with replace", replacing);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "retry-at-once",
      name: "ten simultaneous retries are one command",
      run: async (host) => {
        const key = host.newKey();
        const tries = Array.from({ length: 10 }, () => host.send({ action: "right 90" }, key));
        const numbers = new Set((await Promise.all(tries)).map(({ seq }) => seq));
        must(numbers.size === 1, "one number", [...numbers]);
        await host.waitForEnd([...numbers][0] ?? 0);
        await host.sendAndWait({ action: "left 90" });
      },
    },
    {
      promise: "no-key",
      name: "without an idempotency key each request is a new command",
      run: async (host) => {
        const first = await host.send({ action: "left 90" });
        const second = await host.send({ action: "left 90" });
        must(first.key === null, "key: null", first.key);
        must(first.seq !== second.seq, "two numbers", [first.seq, second.seq]);
        await host.waitForEnd(second.seq);
        await host.sendAndWait({ action: "turn 180" });
      },
    },
    {
      promise: "key-conflict",
      name: "the same key for another command is rejected with 409",
      run: async (host) => {
        const key = host.newKey();
        const first = await host.send({ action: "left 90" }, key);
        const response = await post(host, { action: "right 90" }, key);
        must(response.status === 409, "409", `${response.status} ${response.text}`);
        await host.waitForEnd(first.seq);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "key-form",
      name: "a key that is too short, too long or has other characters is rejected with 400",
      run: async (host) => {
        for (const key of ["short", "k".repeat(65), "with a blank", "sign/sign/sign"]) {
          const response = await post(host, { action: "left 90" }, key);
          must(response.status === 400, `400 for the key ${key}`, response.status);
        }
        const newest = host.newKey();
        for (const key of [newest.slice(-8), newest.padEnd(64, "_")]) {
          const response = await post(host, { action: "stop" }, key);
          must(
            response.status === 202,
            `202 for the key ${key}`,
            `${response.status} ${response.text}`,
          );
        }
      },
    },
    {
      promise: "too-late",
      name: "a command that is too old on arrival is rejected with 422, and its key stays free",
      run: async (host) => {
        const key = host.newKey();
        const command = { action: "left 90", ttl: 1_000 };
        const late = await post(host, { ...command, age: 1_500 }, key);
        must(late.status === 422, "422", `${late.status} ${late.text}`);
        const { type } = validate(problemSchema, late.json, "a problem document");
        must(type.endsWith("/too-late"), "the problem too-late", type);
        const fresh = await post(host, command, key);
        must(fresh.status === 202, "202 for the same key and a new command", fresh.status);
        const { seq } = validate(commandRecordSchema, fresh.json, "a command record");
        await host.waitForEnd(seq);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "ttl",
      name: "a command that has not started within its ttl ends as expired and never runs",
      run: async (host) => {
        await moveToStart(host);
        await busy(host, 2_000);
        await mustExpire(host, { action: "right 90", ttl: 300 });
      },
    },
    {
      promise: "age",
      name: "the age of a retry counts: the deadline is the ttl after the first attempt",
      run: async (host) => {
        await moveToStart(host);
        await busy(host, 2_000);
        await mustExpire(host, { action: "right 90", ttl: 30_000, age: 29_700 });
      },
    },
    {
      promise: "transit",
      name: "with Script-Clock, transit time counts",
      run: async (host) => {
        const clock = host.newKey();
        const time = (sentAt: number) => ({ "Script-Clock": `${clock} ${Math.round(sentAt)}` });
        const startedAt = performance.now();
        await host.request("/commands?after=0", { headers: time(DELAY_MS) });
        const body = { action: "left 90", ttl: 1_000 };
        const delayed = await host.request("/commands", { method: "POST", body, headers: time(0) });
        must(delayed.status === 422, "422 for a delayed command", delayed.status);
        const headers = time(DELAY_MS + performance.now() - startedAt);
        const options = { method: "POST", body: { action: "left 90" }, headers };
        const immediate = await host.request("/commands", options);
        must(
          immediate.status === 202,
          "202 for a command without a delay",
          `${immediate.status} ${immediate.text}`,
        );
        const { seq } = validate(commandRecordSchema, immediate.json, "a command record");
        const end = await host.waitForEnd(seq);
        must(end.state === "completed", "completed", end);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "ttl-waits",
      name: "a command that waits for less than its ttl runs",
      run: async (host) => {
        await busy(host, 1_000);
        const turn = await host.sendAndWait({ action: "left 90" });
        must(turn.state === "completed", "completed", turn);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "ttl-default",
      name: "without a ttl, a command that has not started within 10 s ends as expired",
      run: async (host) => {
        await moveToStart(host);
        await busy(host, 2 * DEFAULT_TTL_MS);
        const startedAt = performance.now();
        await mustExpire(host, { action: "right 90" });
        const waited = performance.now() - startedAt;
        const isRight = Math.abs(waited - DEFAULT_TTL_MS) < DEFAULT_TTL_TOLERANCE_MS;
        must(isRight, "an ending after 10 s", `${Math.round(waited)} ms`);
      },
    },
    {
      promise: "terms",
      name: "ttl, age and lease outside their ranges are rejected with 400",
      run: async (host) => {
        for (const wrong of [{ ttl: 100 }, { ttl: 70_000 }, { age: -1 }, { ttl: "long" }]) {
          const response = await post(host, { action: "left 90", ...wrong });
          must(response.status === 400, `400 for ${JSON.stringify(wrong)}`, response.status);
        }
        for (const lease of [50, 2_500]) {
          const response = await post(host, { action: "drive", left: 0, right: 0, lease });
          must(response.status === 400, `400 for a lease of ${lease} ms`, response.status);
        }
      },
    },
  ],
};

/** Occupies the robot, so that later commands are queued. */
async function busy(host: Host, milliseconds: number): Promise<void> {
  const { seq } = await host.send({ action: "drive", left: 0, right: 0, milliseconds });
  await host.waitForStart(seq);
}

async function mustExpire(host: Host, order: Order): Promise<void> {
  const { seq } = await host.send(order);
  const end = await host.waitForEnd(seq);
  await host.sendAndWait({ action: "stop" });
  must(end.state === "expired", "expired", end);
  await mustHaveReadings(host, START_READINGS, "at the position before the command");
}

async function post(host: Host, body: unknown, key?: string) {
  const headers = key === undefined ? {} : { "Idempotency-Key": key };
  return host.request("/commands", { method: "POST", body, headers });
}
