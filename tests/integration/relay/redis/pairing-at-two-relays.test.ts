import { describe, expect, it, vi } from "vitest";
import { ownerOf, scriptAt } from "../../../../apps/relay/src/testing/pairing-parties.ts";
import { startTestRelay } from "../../../../apps/relay/src/testing/test-relay.ts";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";

/** Status of a script's request to the address from the pairing. */
async function drive(address: string): Promise<number> {
  const { origin, pathname, hash } = new URL(address);
  const answer = await fetch(`${origin}/api/v1/robots/${pathname.slice(3)}/commands`, {
    method: "POST",
    headers: { Authorization: `Bearer ${hash.slice(1)}`, "Content-Type": "application/json" },
    body: JSON.stringify({ action: "left 90" }),
  });
  return answer.status;
}

describe.skipIf(!hasRedis)("pairing with Redis", () => {
  it("works with the page and the script at different relays", async () => {
    const { url } = await startTestRedis();
    const config = { storeUrl: url };
    const relay = await startTestRelay({ config });
    const robot = await relay.register();
    const owner = ownerOf(relay, robot);
    const elsewhere = await startTestRelay({ config });
    const script = scriptAt(elsewhere);
    const shown = owner.show(25);
    const code = await owner.code();
    const key = (await script.ask({ code, name: "Far" })).body?.key ?? "";
    await shown;
    const answer = script.receive(key, 25);
    expect(await owner.say(true)).toBe("");
    const address = (await answer).body?.address ?? "";
    expect(address).toBe(`${elsewhere.origin}/r/${robot.id}#${key}`);
    await vi.waitFor(async () => expect(await drive(address)).toBe(202));
  });
});
