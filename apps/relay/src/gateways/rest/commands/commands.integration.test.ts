import { once } from "node:events";
import { request } from "node:http";
import { expect, it } from "vitest";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { startTestRelay } from "../../../testing/test-relay.ts";
import { TestSocket } from "../../../testing/test-socket.ts";

const TTL = 400;

/** Sends the headers of a command's request, and the body on `finish`. */
async function slowCommand(age: number) {
  const clock = new FakeClock();
  const relay = await startTestRelay({ clock });
  const robot = await relay.register();
  const { socket: page } = await TestSocket.page(relay, robot);
  const post = request(`${relay.origin}/api/v1/robots/${robot.id}/commands`, {
    method: "POST",
    headers: {
      Authorization: `Bearer ${robot.driverKey}`,
      "Content-Type": "application/json",
      // Continues once the relay has read the headers.
      Expect: "100-continue",
    },
  });
  post.flushHeaders();
  await once(post, "continue");
  const finish = async (): Promise<number | undefined> => {
    const answered = once(post, "response");
    post.end(JSON.stringify({ action: "left 90", ttl: TTL, age }));
    const [answer] = (await answered) as [{ statusCode?: number; resume(): void }];
    answer.resume();
    return answer.statusCode;
  };
  return { relay, robot, clock, page, finish };
}

it("counts the time to read a request towards the age of its command", async () => {
  const { clock, page, finish } = await slowCommand(50);
  await clock.pass(300);
  expect(await finish()).toBe(202);
  const { remaining } = await page.next("command");
  expect(remaining).toBe(TTL - 50 - 300);
});

it("rejects a command as too late if its request took longer than its ttl", async () => {
  const { clock, finish } = await slowCommand(0);
  await clock.pass(TTL);
  expect(await finish()).toBe(422);
});

it("rejects a command whose key the owner revokes while its request arrives", async () => {
  const { relay, robot, finish } = await slowCommand(0);
  const body = { kind: "drive", replace: true };
  const revoked = await relay.ask(robot, "/keys", { method: "POST", key: robot.ownerKey, body });
  expect(revoked.status).toBe(201);
  expect(await finish()).toBe(401);
  const log = await relay.ask(robot, "/commands", { key: robot.ownerKey });
  expect(await log.json()).toEqual({ commands: [] });
});

it("accepts fractional milliseconds", async () => {
  const relay = await startTestRelay();
  const robot = await relay.register();
  const body = { action: "drive", left: 0.1, right: 0.1, ttl: 500.5, age: 0.25, lease: 501.109 };
  const answer = await relay.ask(robot, "/commands", { method: "POST", body });
  expect(answer.status).toBe(202);
});
