import { once } from "node:events";
import { spawn } from "node:child_process";
import { join } from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";
import { startRelayProcess } from "../../support/test-relay-process.ts";
import {
  requestsTo,
  startTestRelay,
  testFolder,
  type Requests,
} from "../../../apps/relay/src/testing/test-relay.ts";
import { TestSocket } from "../../../apps/relay/src/testing/test-socket.ts";

const READY = /Corridor is ready: (http:\S+)/;

async function startProcess(environment: Record<string, string> = {}) {
  const process = await startRelayProcess({ environment });
  return { process, relay: requestsTo(process.url) };
}

/** Waits until the relay reports that it is not ready. */
async function unready({ origin }: Requests): Promise<unknown> {
  for (;;) {
    const answer = await fetch(`${origin}/readyz`);
    if (answer.status === 503) return answer.json();
    await answer.text();
  }
}

describe("a relay that receives a signal to shut down", () => {
  it("first reports not ready, then answers open requests, closes sockets and exits with 0", async () => {
    const { process, relay } = await startProcess({ DRAIN_SECONDS: "1" });
    const robot = await relay.register();
    const page = await TestSocket.page(relay, robot);
    const script = await TestSocket.driver(relay, robot);
    const events = await relay.ask(robot, "/events");
    await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    await page.socket.next("command");
    const waiting = relay.ask(robot, "/commands/1?wait=25");

    process.signal("SIGTERM");
    expect(await unready(relay)).toMatchObject({ type: "/problems/restarting", status: 503 });
    // Existing clients continue until the load balancer has noticed.
    expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
    const late = await relay.ask(robot, "/commands", { method: "POST", body: { action: "stop" } });
    expect(late.status).toBe(202);

    expect((await page.socket.closed).code).toBe(1012);
    expect((await script.closed).code).toBe(1012);
    const record = await waiting;
    expect([record.status, await record.json()]).toMatchObject([200, { state: "delivered" }]);
    expect(await events.text()).toContain("event: state");
    expect(await process.exitCode()).toBe(0);
  });

  it("exits immediately on a second SIGTERM", async () => {
    const { process, relay } = await startProcess({ DRAIN_SECONDS: "60" });
    process.signal("SIGTERM");
    await unready(relay);
    // Signals within half a second belong to the same press of a key.
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
    process.signal("SIGTERM");
    expect(await process.exitCode()).toBe(1);
  });

  it.each([
    ["SIGINT", "SIGTERM"],
    ["SIGTERM", "SIGINT"],
  ] as const)(
    "shuts down cleanly on one press of Ctrl+C that sends two signals, as under npm (%s first)",
    async (...signals) => {
      const { process } = await startProcess({ DRAIN_SECONDS: "60" });
      for (const signal of signals) process.signal(signal);
      expect(await process.exitCode()).toBe(0);
    },
  );

  it("does not wait for load balancers on Ctrl+C", async () => {
    const { process } = await startProcess({ DRAIN_SECONDS: "60" });
    process.signal("SIGINT");
    expect(await process.exitCode()).toBe(0);
  });

  it("drops connections that do not read the close frame", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const script = await TestSocket.driver(relay, robot);
    script.pause();
    await relay.close();
    await expect(fetch(`${relay.origin}/healthz`)).rejects.toThrow(/fetch failed/);
  });

  it("shuts down cleanly under npm start", async () => {
    // Skips the build step, which other tests cover.
    const npm = spawn("npm", ["start", "--ignore-scripts"], {
      cwd: join(import.meta.dirname, "../../.."),
      env: { ...process.env, PORT: "0", HOST: "127.0.0.1", DATA_DIR: testFolder() },
      stdio: ["ignore", "pipe", "inherit"],
    });
    onTestFinished(() => void npm.kill("SIGKILL"));
    let text = "";
    while (!READY.test(text)) text += String((await once(npm.stdout, "data"))[0]);
    const relay = requestsTo(READY.exec(text)?.[1] ?? "");
    const page = await TestSocket.page(relay, await relay.register());
    npm.kill("SIGTERM");
    expect((await page.socket.closed).code).toBe(1012);
    // The pipe closes when the relay, the last process that holds it, exits.
    await once(npm.stdout, "end");
    await expect(fetch(`${relay.origin}/healthz`)).rejects.toThrow(/fetch failed/);
  });
});
