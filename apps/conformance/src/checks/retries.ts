/** A command that is sent again is done once, and never late. */
import { commandRecordSchema, problemSchema } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import type { Host } from "../host.ts";
import { must, NotSeen, shaped } from "../mismatch.ts";

export const retries: CheckGroup = {
  title: "Retries, keys and ages",
  checks: [
    {
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
      },
    },
    {
      name: "ten tries at the same moment are one command",
      run: async (host) => {
        const key = host.newKey();
        const tries = Array.from({ length: 10 }, () => host.send({ action: "right 90" }, key));
        const numbers = new Set((await Promise.all(tries)).map(({ seq }) => seq));
        must(numbers.size === 1, "one number", [...numbers]);
        await host.ended([...numbers][0] ?? 0);
      },
    },
    {
      name: "without a key every command is one of its own",
      run: async (host) => {
        const first = await host.send({ action: "left 90" });
        const second = await host.send({ action: "left 90" });
        must(first.key === null, "key: null", first.key);
        must(first.seq !== second.seq, "two numbers", [first.seq, second.seq]);
        await host.ended(second.seq);
      },
    },
    {
      name: "the same key for another command is refused with 409",
      run: async (host) => {
        const key = host.newKey();
        const first = await host.send({ action: "left 90" }, key);
        const answer = await post(host, { action: "right 90" }, key);
        must(answer.status === 409, "409", `${answer.status} ${answer.text}`);
        await host.ended(first.seq);
      },
    },
    {
      name: "a key that is too short, too long or has other signs is refused with 400",
      run: async (host) => {
        for (const key of ["short", "k".repeat(65), "with a blank", "sign/sign/sign"]) {
          const answer = await post(host, { action: "left 90" }, key);
          must(answer.status === 400, `400 for the key ${key}`, answer.status);
        }
      },
    },
    {
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
      },
    },
    {
      name: "what could not begin within its time to live ends as expired, and is not done",
      run: async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 5_000,
        });
        const before = await host.snapshot();
        const wish = await host.send({ action: "right 90", ttl: 300 });
        const end = await host.ended(wish.seq);
        await host.done({ action: "stop" });
        await host.ended(seq);
        if (end.state === "completed") {
          throw new NotSeen("this robot does everything at once: nothing ever waits for it");
        }
        must(end.state === "expired", "expired", end);
        const { pose } = await host.snapshot();
        const turned = Math.abs(pose.heading - before.pose.heading);
        must(turned < 2, "the heading from before", pose.heading);
      },
    },
    {
      name: "times to live and ages out of their ranges are refused with 400",
      run: async (host) => {
        for (const wrong of [{ ttl: 100 }, { ttl: 70_000 }, { age: -1 }, { ttl: "long" }]) {
          const answer = await post(host, { action: "left 90", ...wrong });
          must(answer.status === 400, `400 for ${JSON.stringify(wrong)}`, answer.status);
        }
      },
    },
  ],
};

async function post(host: Host, body: unknown, key?: string) {
  const headers = key === undefined ? {} : { "Idempotency-Key": key };
  return host.ask("/commands", { method: "POST", body, headers });
}
