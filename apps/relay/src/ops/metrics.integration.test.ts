import { describe, expect, it } from "vitest";
import { completed } from "../platform/testing/messages.ts";
import { ClassAtRelay } from "../testing/class-at-relay.ts";
import { mcpUrl } from "../testing/mcp-client.ts";
import { RosClient } from "../testing/ros-client.ts";
import { startTestRelay, type TestRelay } from "../testing/test-relay.ts";
import { TestSocket } from "../testing/test-socket.ts";
import { Metrics } from "./metrics.ts";

const config = { metricsPort: 0 };

async function scrape({ metricsPort }: TestRelay): Promise<string> {
  const answer = await fetch(`http://127.0.0.1:${metricsPort}/metrics`);
  expect(answer.headers.get("content-type")).toMatch(/^text\/plain; version=0\.0\.4/);
  return answer.text();
}

/** Value of a metric, or null if it is missing. */
function valueOf(text: string, name: string): number | null {
  const line = text.split("\n").find((each) => each.startsWith(`${name} `));
  return line === undefined ? null : Number(line.slice(name.length + 1));
}

describe("/metrics", () => {
  it("counts messages and requests of gateways, refused ones included", async () => {
    const relay = await startTestRelay({ config });
    const robot = await relay.register();
    const client = await RosClient.connect(relay, robot);
    await client.call("/rosapi/nodes");
    client.sendText("no JSON");
    await client.call("/rosapi/topics");
    const request = { method: "POST", body: JSON.stringify({ jsonrpc: "2.0", id: 1 }) };
    await fetch(mcpUrl(relay, robot), request);
    const text = await scrape(relay);
    expect(valueOf(text, 'corridor_gateway_messages_total{gateway="ros"}')).toBe(3);
    expect(valueOf(text, 'corridor_gateway_messages_total{gateway="mcp"}')).toBe(1);
  });

  it("reports events without identifying robots, keys or clients", async () => {
    const relay = await startTestRelay({ config });
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const script = await TestSocket.driver(relay, robot);
    const stop = new AbortController();
    const events = await relay.ask(robot, "/events", { signal: stop.signal });
    const post = { method: "POST", headers: { "Idempotency-Key": "a-key-of-the-script" } };
    await relay.ask(robot, "/commands", { ...post, body: { action: "left 90" } });
    await relay.ask(robot, "/commands", { ...post, body: { action: "right 90" } });
    await relay.ask(robot, "/commands", { key: "drv_nobody" });
    script.sendRaw("no JSON");
    await script.next("problem");
    await page.next("command");
    page.send({ type: "started", epoch, seq: 1 });
    page.send({ type: "ended", epoch, ...completed(1) });
    await page.next("stored");
    const stranger = await TestSocket.open(relay, robot.id);
    stranger.sendRaw("hello");
    await stranger.closed;

    const text = await scrape(relay);
    const expected = {
      corridor_robots_with_page: 1,
      'corridor_readers{transport="websocket"}': 1,
      'corridor_readers{transport="events"}': 1,
      'corridor_readers{transport="long-poll"}': 0,
      'corridor_commands_ended_total{state="completed"}': 1,
      'corridor_refusals_total{problem="key-conflict"}': 1,
      'corridor_refusals_total{problem="not-authorised"}': 1,
      'corridor_refusals_total{problem="bad-request"}': 1,
      'corridor_sockets_closed_total{code="4401"}': 1,
      corridor_post_to_stored_seconds_count: 1,
      corridor_post_to_started_seconds_count: 1,
    };
    const found = Object.keys(expected).map((name) => [name, valueOf(text, name)]);
    expect(Object.fromEntries(found)).toEqual(expected);
    expect(valueOf(text, "corridor_store_commit_seconds_count")).toBeGreaterThan(4);
    expect(valueOf(text, "process_resident_memory_bytes")).toBeGreaterThan(0);
    for (const secret of [robot.id, robot.driverKey, robot.ownerKey, "a-key-of", "127.0.0.1"]) {
      expect(text).not.toContain(secret);
    }
    stop.abort();
    await events.text().catch(() => undefined);
  });

  it("counts the connections to classes by role, without identifying them", async () => {
    const relay = await startTestRelay({ config });
    const [room, other] = [await ClassAtRelay.create(relay), await ClassAtRelay.create(relay)];
    const [ada, bo] = [await room.join(), await room.join()];
    await other.join();
    await Promise.all([room.student(ada), room.student(bo), room.teacher(), room.screen()]);
    await room.screen();
    const text = await scrape(relay);
    const expected = {
      corridor_classes: 1,
      'corridor_class_members{role="learn"}': 2,
      'corridor_class_members{role="teach"}': 1,
      'corridor_class_members{role="show"}': 2,
    };
    const found = Object.keys(expected).map((name) => [name, valueOf(text, name)]);
    expect(Object.fromEntries(found)).toEqual(expected);
    const { id, code, teacherKey, screenKey } = room.created;
    for (const secret of [id, code, teacherKey, screenKey, ada.key]) {
      expect(text).not.toContain(secret);
    }
    await room.direct("DELETE");
    await expect.poll(async () => valueOf(await scrape(relay), "corridor_classes")).toBe(0);
  });

  it("is not served on the public port", async () => {
    const relay = await startTestRelay({ config });
    expect((await fetch(`${relay.origin}/metrics`)).status).toBe(404);
    expect((await fetch(`http://127.0.0.1:${relay.metricsPort}/`)).status).toBe(404);
    const post = { method: "POST" };
    expect((await fetch(`http://127.0.0.1:${relay.metricsPort}/metrics`, post)).status).toBe(405);
    await relay.close();
    await expect(scrape(relay)).rejects.toThrow(/fetch failed/);
  });

  it("is disabled by default", async () => {
    expect((await startTestRelay()).metricsPort).toBeNull();
  });

  it("limits the number of time series for close codes", async () => {
    const metrics = new Metrics();
    for (let code = 3000; code < 5000; code++) metrics.socketClosed(code);
    const { text } = await metrics.report();
    expect(text).toContain('{code="other"}');
    expect(text.match(/corridor_sockets_closed_total\{/g)?.length).toBeLessThan(20);
  });
});
