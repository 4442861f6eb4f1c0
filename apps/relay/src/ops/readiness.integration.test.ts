import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { problemSchema } from "@corridor/protocol";
import { pino } from "pino";
import { describe, expect, it, onTestFinished } from "vitest";
import { Readiness } from "./readiness.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { startTestRelay, testFolder, type TestRelay } from "../testing/test-relay.ts";

const log = pino({ level: "silent" });

/** A store with a configurable result that counts its checks. */
function withStore() {
  const store = { answer: (): "ok" | "full" => "ok", asked: 0 };
  const clock = new FakeClock();
  const check = async () => {
    store.asked += 1;
    return store.answer();
  };
  return { store, clock, readiness: new Readiness({ check }, clock, log) };
}

describe("readiness", () => {
  it("follows the store within ten seconds in both directions", async () => {
    const { store, clock, readiness } = withStore();
    expect(await readiness.status()).toBe("ready");
    store.answer = () => "full";
    await clock.pass(5_000);
    expect(await readiness.status()).toBe("degraded");
    store.answer = () => {
      throw new Error("/var/lib/corridor is gone");
    };
    await clock.pass(5_000);
    expect(await readiness.status()).toBe("unavailable");
    store.answer = () => "ok";
    await clock.pass(5_000);
    expect(await readiness.status()).toBe("ready");
  });

  it("checks the store once for concurrent requests", async () => {
    const { store, readiness } = withStore();
    await Promise.all(Array.from({ length: 100 }, () => readiness.status()));
    expect(store.asked).toBe(1);
  });

  it("stays draining once the relay drains", async () => {
    const { readiness } = withStore();
    readiness.drain();
    expect(await readiness.status()).toBe("draining");
  });
});

describe("/readyz", () => {
  it("returns a short JSON body that is never cached", async () => {
    const relay = await startTestRelay();
    const answer = await fetch(`${relay.origin}/readyz`);
    expect([answer.status, await answer.json()]).toEqual([200, { status: "ready" }]);
    expect(answer.headers.get("cache-control")).toBe("no-store");
    for (const path of ["/readyz", "/healthz"]) {
      expect((await fetch(relay.origin + path, { method: "POST" })).status).toBe(405);
    }
  });

  /** A load balancer avoids the relay, and a process manager lets it run. */
  async function expectAvoided({ origin }: TestRelay, type: string): Promise<void> {
    const answer = await fetch(`${origin}/readyz`);
    expect(answer.status).toBe(503);
    expect(Number(answer.headers.get("retry-after"))).toBeGreaterThan(0);
    expect(problemSchema.parse(await answer.json())).toMatchObject({ status: 503, type });
    expect((await fetch(`${origin}/healthz`)).status).toBe(200);
  }

  it("makes a load balancer avoid a relay that shuts down, before it closes", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const closed = relay.close(5_000);
    await expectAvoided(relay, "/problems/restarting");
    await clock.pass(5_000);
    await closed;
    await expect(fetch(`${relay.origin}/healthz`)).rejects.toThrow(/fetch failed/);
  });

  it("makes a load balancer avoid a relay that cannot write, until it can again", async () => {
    const clock = new FakeClock();
    const dataDir = testFolder();
    const relay = await startTestRelay({ clock, dataDir });
    const other = new DatabaseSync(join(dataDir, "corridor.sqlite"));
    onTestFinished(() => other.close());
    other.exec("BEGIN IMMEDIATE");
    await expectAvoided(relay, "/problems/no-store");
    other.exec("ROLLBACK");
    await clock.pass(5_000);
    expect((await fetch(`${relay.origin}/readyz`)).status).toBe(200);
  });
});
