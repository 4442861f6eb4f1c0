/** Marks that a script draws over the maze: sent to the page and to viewers, and never stored. */
import { createdKeySchema, type Registration } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";

const cell = { column: 1, row: 3, text: "7", color: "green", walls: "ns" };
const marks = { type: "marks", fresh: false, pitch: 2, cells: [cell] };
const none = { type: "marks", fresh: true, pitch: 1, cells: [] };

async function watchKey(relay: TestRelay, robot: Registration): Promise<string> {
  const request = { method: "POST", key: robot.ownerKey, body: { kind: "watch" } };
  return createdKeySchema.parse(await (await relay.ask(robot, "/keys", request)).json()).key;
}

async function withReaders() {
  const clock = new FakeClock();
  const relay = await startTestRelay({ clock });
  const robot = await relay.register();
  const { socket: page } = await TestSocket.page(relay, robot);
  const key = await watchKey(relay, robot);
  const viewer = await TestSocket.open(relay, robot.id);
  viewer.send({ type: "hello", version: 1, role: "watch", key });
  await viewer.next("welcome");
  const script = await TestSocket.driver(relay, robot);
  return { clock, relay, robot, page, viewer, script };
}

describe("marks of a script", () => {
  it("reach the page and viewers, and end with the script", async () => {
    const { page, viewer, script } = await withReaders();
    script.send(marks);
    script.send(marks);
    for (const reader of [page, viewer]) {
      // The first ones of a connection replace those of others.
      expect(await reader.next("marks")).toEqual({ ...marks, fresh: true });
      expect(await reader.next("marks")).toEqual(marks);
    }
    script.close();
    for (const reader of [page, viewer]) expect(await reader.next("marks")).toEqual(none);
  });

  it("do not reach other scripts", async () => {
    const { relay, robot, viewer, script } = await withReaders();
    const other = await TestSocket.driver(relay, robot);
    script.send(marks);
    await viewer.next("marks");
    other.send({ type: "command", command: { action: "fly" } });
    expect(await other.next("marks", "problem")).toMatchObject({ type: "problem" });
  });

  it("are refused beyond ten a second, with a sentence", async () => {
    const { clock, page, script } = await withReaders();
    for (let n = 0; n <= limits.marksRate.burst; n += 1) script.send(marks);
    expect(await script.next("problem")).toMatchObject({
      key: null,
      problem: { type: "/problems/too-fast", detail: expect.stringContaining("10 a second") },
    });
    for (let n = 0; n < limits.marksRate.burst; n += 1) await page.next("marks");
    await clock.pass(100);
    script.send(marks);
    expect(await page.next("marks")).toEqual(marks);
  });

  it("need a key that drives", async () => {
    const { viewer } = await withReaders();
    viewer.send(marks);
    expect((await viewer.closed).code).toBe(4403);
  });

  it.each([
    { name: "a long text", change: { text: "a longer text" } },
    { name: "another script", change: { text: "\u00e9" } },
    { name: "an unknown colour", change: { color: "url(x)" } },
    { name: "another wall", change: { walls: "x" } },
    { name: "a cell outside of every maze", change: { column: 256 } },
    { name: "an unknown field", change: { html: "<b>" } },
  ])("are refused with $name", async ({ change }) => {
    const { script } = await withReaders();
    script.send({ ...marks, cells: [{ ...cell, ...change }] });
    expect(await script.next("problem")).toMatchObject({
      problem: { type: "/problems/bad-request", detail: expect.stringContaining("cells[0]") },
    });
  });
});
