/** A host executes a repeated command once, and never after its ttl. */
import { commandRecordSchema, problemSchema, type Order } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import type { Host } from "../host.ts";
import { must, shaped } from "../mismatch.ts";
import { atHome, HOME, mustRead } from "../setting.ts";

/** additional transit time of a command in ms */
const HELD_MS = 1_500;
const DEFAULT_TTL_MS = 10_000;
/** A slow network delays both ends of a wait. */
const DEFAULT_TTL_SLACK_MS = 2_500;

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
        const end = await host.ended(first.seq);
        const late = await host.send({ action: "left 90", age: 60_000 }, key);
        must(late.seq === first.seq && late.state === end.state, "the same also later", late);
        const other = await host.send({ action: "left 90", ttl: 20_000 }, key);
        must(other.seq === first.seq, "the same with another ttl, which is no part of it", other);
        const replacing = await host.send({ action: "left 90", replace: true }, key);
        must(
          replacing.seq === first.seq,
          "the same with replace, which is no part of it",
          replacing,
        );
        await host.done({ action: "right 90" });
      },
    },
    {
      promise: "retry-at-once",
      name: "ten tries at the same moment are one command",
      run: async (host) => {
        const key = host.newKey();
        const tries = Array.from({ length: 10 }, () => host.send({ action: "right 90" }, key));
        const numbers = new Set((await Promise.all(tries)).map(({ seq }) => seq));
        must(numbers.size === 1, "one number", [...numbers]);
        await host.ended([...numbers][0] ?? 0);
        await host.done({ action: "left 90" });
      },
    },
    {
      promise: "no-key",
      name: "without a key every command is one of its own",
      run: async (host) => {
        const first = await host.send({ action: "left 90" });
        const second = await host.send({ action: "left 90" });
        must(first.key === null, "key: null", first.key);
        must(first.seq !== second.seq, "two numbers", [first.seq, second.seq]);
        await host.ended(second.seq);
        await host.done({ action: "turn 180" });
      },
    },
    {
      promise: "key-conflict",
      name: "the same key for another command is refused with 409",
      run: async (host) => {
        const key = host.newKey();
        const first = await host.send({ action: "left 90" }, key);
        const answer = await post(host, { action: "right 90" }, key);
        must(answer.status === 409, "409", `${answer.status} ${answer.text}`);
        await host.ended(first.seq);
        await host.done({ action: "right 90" });
      },
    },
    {
      promise: "key-form",
      name: "a key that is too short, too long or has other signs is refused with 400",
      run: async (host) => {
        for (const key of ["short", "k".repeat(65), "with a blank", "sign/sign/sign"]) {
          const answer = await post(host, { action: "left 90" }, key);
          must(answer.status === 400, `400 for the key ${key}`, answer.status);
        }
        const newest = host.newKey();
        for (const key of [newest.slice(-8), newest.padEnd(64, "_")]) {
          const answer = await post(host, { action: "stop" }, key);
          must(answer.status === 202, `202 for the key ${key}`, `${answer.status} ${answer.text}`);
        }
      },
    },
    {
      promise: "too-late",
      name: "a command that is too old on arrival is refused with 422, and its key stays free",
      run: async (host) => {
        const key = host.newKey();
        const wish = { action: "left 90", ttl: 1_000 };
        const late = await post(host, { ...wish, age: 1_500 }, key);
        must(late.status === 422, "422", `${late.status} ${late.text}`);
        const { type } = shaped(problemSchema, late.json, "a problem document");
        must(type.endsWith("/too-late"), "the problem too-late", type);
        const fresh = await post(host, wish, key);
        must(fresh.status === 202, "202 for the same key with a fresh wish", fresh.status);
        const { seq } = shaped(commandRecordSchema, fresh.json, "a command record");
        await host.ended(seq);
        await host.done({ action: "right 90" });
      },
    },
    {
      promise: "ttl",
      name: "what could not start within its time to live ends as expired, undone",
      run: async (host) => {
        await atHome(host);
        await busy(host, 2_000);
        await mustExpire(host, { action: "right 90", ttl: 300 });
      },
    },
    {
      promise: "age",
      name: "the age of a retry counts: it starts within the time to live of its first try",
      run: async (host) => {
        await atHome(host);
        await busy(host, 2_000);
        await mustExpire(host, { action: "right 90", ttl: 30_000, age: 29_700 });
      },
    },
    {
      promise: "transit",
      name: "the time that a command spends on its way counts, where its script sends a time",
      run: async (host) => {
        const clock = host.newKey();
        const time = (sentAt: number) => ({ "Script-Clock": `${clock} ${Math.round(sentAt)}` });
        const began = performance.now();
        await host.ask("/commands?after=0", { headers: time(HELD_MS) });
        const body = { action: "left 90", ttl: 1_000 };
        const held = await host.ask("/commands", { method: "POST", body, headers: time(0) });
        must(held.status === 422, "422 for a command that was held up", held.status);
        const headers = time(HELD_MS + performance.now() - began);
        const options = { method: "POST", body: { action: "left 90" }, headers };
        const quick = await host.ask("/commands", options);
        must(quick.status === 202, "202 for one that was not", `${quick.status} ${quick.text}`);
        const { seq } = shaped(commandRecordSchema, quick.json, "a command record");
        const end = await host.ended(seq);
        must(end.state === "completed", "completed", end);
        await host.done({ action: "right 90" });
      },
    },
    {
      promise: "ttl-waits",
      name: "what can start within its time to live is done",
      run: async (host) => {
        await busy(host, 1_000);
        const turn = await host.done({ action: "left 90" });
        must(turn.state === "completed", "completed", turn);
        await host.done({ action: "right 90" });
      },
    },
    {
      promise: "ttl-default",
      name: "without a time to live, what could not start within 10 s ends as expired",
      run: async (host) => {
        await atHome(host);
        await busy(host, 2 * DEFAULT_TTL_MS);
        const began = performance.now();
        await mustExpire(host, { action: "right 90" });
        const waited = performance.now() - began;
        const isRight = Math.abs(waited - DEFAULT_TTL_MS) < DEFAULT_TTL_SLACK_MS;
        must(isRight, "an ending after 10 s", `${Math.round(waited)} ms`);
      },
    },
    {
      promise: "terms",
      name: "times to live, ages and leases out of their ranges are refused with 400",
      run: async (host) => {
        for (const wrong of [{ ttl: 100 }, { ttl: 70_000 }, { age: -1 }, { ttl: "long" }]) {
          const answer = await post(host, { action: "left 90", ...wrong });
          must(answer.status === 400, `400 for ${JSON.stringify(wrong)}`, answer.status);
        }
        for (const lease of [50, 2_500]) {
          const answer = await post(host, { action: "drive", left: 0, right: 0, lease });
          must(answer.status === 400, `400 for a lease of ${lease} ms`, answer.status);
        }
      },
    },
  ],
};

/** Occupies the robot, so that later commands are queued. */
async function busy(host: Host, milliseconds: number): Promise<void> {
  const { seq } = await host.send({ action: "drive", left: 0, right: 0, milliseconds });
  await host.begun(seq);
}

async function mustExpire(host: Host, order: Order): Promise<void> {
  const wish = await host.send(order);
  const end = await host.ended(wish.seq);
  await host.done({ action: "stop" });
  must(end.state === "expired", "expired", end);
  await mustRead(host, HOME, "where it stood before");
}

async function post(host: Host, body: unknown, key?: string) {
  const headers = key === undefined ? {} : { "Idempotency-Key": key };
  return host.ask("/commands", { method: "POST", body, headers });
}
