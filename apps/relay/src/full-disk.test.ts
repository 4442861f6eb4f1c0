import { DatabaseSync } from "node:sqlite";
import { problemSchema } from "@corridor/protocol";
import { expect, it, onTestFinished, vi } from "vitest";
import { startTestRelay } from "./testing/test-relay.ts";
import { TestSocket } from "./testing/test-socket.ts";

/** More than the free room of one database page takes, no more than may be sent at once. */
const MOST_POSTS = 40;

/** A relay whose database can be kept from growing, by the limit that SQLite itself has for that. */
async function withSmallDisk() {
  const exec = vi.spyOn(DatabaseSync.prototype, "exec");
  onTestFinished(() => exec.mockRestore());
  const relay = await startTestRelay();
  const db = exec.mock.contexts[0];
  if (!(db instanceof DatabaseSync)) throw new Error("the relay opened no database");
  return {
    relay,
    fill: () => db.exec("PRAGMA max_page_count = 1"),
    makeRoom: () => db.exec("PRAGMA max_page_count = 100000"),
  };
}

it("a full disk is answered with 507, loses nothing that was acknowledged, and passes", async () => {
  const { relay, fill, makeRoom } = await withSmallDisk();
  const robot = await relay.register();
  const post = (n: number) =>
    relay.ask(robot, "/commands", {
      method: "POST",
      body: { action: "left 90" },
      headers: { "Idempotency-Key": `${"k".repeat(50)}-${n}` },
    });
  fill();
  let stored = 0;
  let answer = await post(stored + 1);
  while (answer.status === 202 && stored < MOST_POSTS) answer = await post(++stored + 1);

  expect(answer.status).toBe(507);
  expect(answer.headers.get("retry-after")).toBe("60");
  expect(problemSchema.parse(await answer.json())).toMatchObject({
    type: "/problems/storage-full",
  });
  expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
  // It still serves who is there: a balancer must not take it away.
  const ready = await fetch(`${relay.origin}/readyz`);
  expect([ready.status, await ready.json()]).toEqual([200, { status: "degraded" }]);
  const log = await relay.ask(robot, "/commands");
  expect(await log.json()).toMatchObject({
    commands: Array.from({ length: stored }, (_, n) => ({ seq: n + 1, state: "accepted" })),
  });

  makeRoom();
  const retry = await post(stored + 1);
  expect(retry.status).toBe(202);
  expect(await retry.json()).toMatchObject({ seq: stored + 1, duplicate: false });
  const { socket: page } = await TestSocket.page(relay, robot);
  expect(await page.next("command")).toMatchObject({ seq: 1 });
});
