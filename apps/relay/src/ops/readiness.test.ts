import { problemSchema } from "@corridor/protocol";
import { pino } from "pino";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { Readiness } from "./readiness.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { startTestRelay } from "../testing/test-relay.ts";

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

  it.each([
    { name: "drains", status: "draining", type: "/problems/restarting" },
    { name: "cannot reach its store", status: "unavailable", type: "/problems/no-store" },
  ] as const)("makes a load balancer avoid a relay that $name", async ({ status, type }) => {
    const statusSpy = vi.spyOn(Readiness.prototype, "status").mockResolvedValue(status);
    onTestFinished(() => statusSpy.mockRestore());
    const relay = await startTestRelay();
    const answer = await fetch(`${relay.origin}/readyz`);
    expect(answer.status).toBe(503);
    expect(Number(answer.headers.get("retry-after"))).toBeGreaterThan(0);
    expect(problemSchema.parse(await answer.json())).toMatchObject({ status: 503, type });
    expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
  });
});
