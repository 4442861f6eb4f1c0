import { problemSchema, type Registration } from "@corridor/protocol";
import { expect, it, vi } from "vitest";
import { completed } from "../../../apps/relay/src/platform/testing/messages.ts";
import { smallDisk } from "../../support/test-small-disk.ts";
import { startTestRelay, type TestRelay } from "../../../apps/relay/src/testing/test-relay.ts";
import { TestSocket } from "../../../apps/relay/src/testing/test-socket.ts";

/**
 * More commands than fit into the free space of one database page, and no more than the rate limit.
 */
const MAX_POSTS = 40;
/** time limit for the relay to notice free space again */
const RECOVERY = { timeout: 10_000, interval: 200 };

function posts(relay: TestRelay, robot: Registration) {
  return (n: number) =>
    relay.ask(robot, "/commands", {
      method: "POST",
      body: { action: "left 90" },
      headers: { "Idempotency-Key": `${"k".repeat(50)}-${n}` },
    });
}

it("answers 507 on a full disk, keeps acknowledged commands, and recovers", async ({ skip }) => {
  const disk = smallDisk(10, skip);
  const relay = await startTestRelay({ dataDir: disk.folder });
  const robot = await relay.register();
  const post = posts(relay, robot);
  disk.fill();
  let stored = 0;
  let answer = await post(stored + 1);
  while (answer.status === 202 && stored < MAX_POSTS) answer = await post(++stored + 1);

  expect(answer.status).toBe(507);
  expect(answer.headers.get("retry-after")).toBe("60");
  expect(problemSchema.parse(await answer.json())).toMatchObject({
    type: "/problems/storage-full",
  });
  expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
  // It still serves existing clients, so a load balancer must not remove it.
  const ready = await fetch(`${relay.origin}/readyz`);
  expect([ready.status, await ready.json()]).toEqual([200, { status: "degraded" }]);
  const log = await relay.ask(robot, "/commands");
  expect(await log.json()).toMatchObject({
    commands: Array.from({ length: stored }, (_, n) => ({ seq: n + 1, state: "accepted" })),
  });

  disk.freeSpace();
  const retry = await vi.waitFor(async () => {
    const again = await post(stored + 1);
    expect(again.status).toBe(202);
    return again;
  }, RECOVERY);
  expect(await retry.json()).toMatchObject({ seq: stored + 1, duplicate: false });
  const { socket: page } = await TestSocket.page(relay, robot);
  expect(await page.next("command")).toMatchObject({ seq: 1 });
});

it("lets the robot end its command and owners delete while the disk is full", async ({ skip }) => {
  const disk = smallDisk(10, skip);
  const relay = await startTestRelay({ dataDir: disk.folder });
  const robot = await relay.register();
  const other = await relay.register();
  const post = posts(relay, robot);
  await post(1);
  const { socket: page, epoch } = await TestSocket.page(relay, robot);
  await page.next("command");

  disk.fill();
  await vi.waitFor(async () => expect((await post(2)).status).toBe(507), RECOVERY);
  page.send({ type: "started", epoch, seq: 1 });
  page.send({ type: "ended", epoch, ...completed(1) });
  expect(await page.next("stored")).toMatchObject({ seq: 1 });
  const stop = await relay.ask(robot, "/commands", { method: "DELETE" });
  expect(stop.status).toBe(202);
  const gone = await relay.ask(other, "", { method: "DELETE", key: other.ownerKey });
  expect(gone.status).toBe(204);

  disk.freeSpace();
  await vi.waitFor(async () => expect((await post(3)).status).toBe(202), RECOVERY);
  const log = await relay.ask(robot, "/commands/1");
  expect(await log.json()).toMatchObject({ seq: 1, state: "completed" });
});
