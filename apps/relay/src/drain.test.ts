import { once } from "node:events";
import { spawn } from "node:child_process";
import { join } from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";
import { startRelayProcess } from "./testing/relay-process.ts";
import { requestsTo, startTestRelay, testFolder, type Requests } from "./testing/test-relay.ts";
import { TestSocket } from "./testing/test-socket.ts";

const READY = /Corridor is ready: (http:\S+)/;

async function startProcess(environment: Record<string, string> = {}) {
  const process = startRelayProcess(environment);
  const [, origin = ""] = await process.says(READY);
  return { process, relay: requestsTo(origin) };
}

/** Waits until the relay says that it is not ready. */
async function unready({ origin }: Requests): Promise<unknown> {
  for (;;) {
    const answer = await fetch(`${origin}/readyz`);
    if (answer.status === 503) return answer.json();
    await answer.text();
  }
}

describe("a relay that is told to end", () => {
  it("says so first, then sends all away with an answer, and ends with 0", async () => {
    const { process, relay } = await startProcess({ DRAIN_SECONDS: "1" });
    const robot = await relay.register();
    const page = await TestSocket.page(relay, robot);
    const script = await TestSocket.driver(relay, robot);
    const events = await relay.ask(robot, "/events");
    await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    await page.socket.next("command");
    const waiting = relay.ask(robot, "/commands/1?wait=25");

    process.child.kill("SIGTERM");
    expect(await unready(relay)).toMatchObject({ type: "/problems/restarting", status: 503 });
    // Those who are there go on until the balancer has seen it.
    expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
    const late = await relay.ask(robot, "/commands", { method: "POST", body: { action: "stop" } });
    expect(late.status).toBe(202);

    expect((await page.socket.closed).code).toBe(1012);
    expect((await script.closed).code).toBe(1012);
    const record = await waiting;
    expect([record.status, await record.json()]).toMatchObject([200, { state: "delivered" }]);
    expect(await events.text()).toContain("event: state");
    expect(await process.ended()).toBe(0);
  });

  it("ends at once when it is told twice", async () => {
    const { process, relay } = await startProcess({ DRAIN_SECONDS: "60" });
    process.child.kill("SIGTERM");
    await unready(relay);
    // One press of Ctrl+C may come as two signals; two presses are further apart.
    process.child.kill("SIGTERM");
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
    process.child.kill("SIGTERM");
    expect(await process.ended()).toBe(1);
  });

  it("does not wait for balancers when Ctrl+C is pressed", async () => {
    const { process } = await startProcess({ DRAIN_SECONDS: "60" });
    process.child.kill("SIGINT");
    expect(await process.ended()).toBe(0);
  });

  it("cuts those off who do not read the goodbye", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const script = await TestSocket.driver(relay, robot);
    script.pause();
    await relay.close();
    await expect(fetch(`${relay.origin}/healthz`)).rejects.toThrow(/fetch failed/);
  });

  it("ends in order under npm start", async () => {
    // Without the build before it, which other tests do.
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
    // The pipe ends when the last process that holds it has ended: the relay itself.
    await once(npm.stdout, "end");
    await expect(fetch(`${relay.origin}/healthz`)).rejects.toThrow(/fetch failed/);
  });
});
