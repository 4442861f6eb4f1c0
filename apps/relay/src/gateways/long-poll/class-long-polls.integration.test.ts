/** Long-poll connections of a class, for networks without WebSockets. */
import { expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { ClassAtRelay, tile } from "../../testing/class-at-relay.ts";
import { TestConnection } from "../../testing/test-connection.ts";
import { startTestRelay } from "../../testing/test-relay.ts";

async function classWithStudent() {
  const clock = new FakeClock();
  const room = await ClassAtRelay.create(await startTestRelay({ clock }));
  const { key } = await room.join();
  const connect = async (role: string, own: string) =>
    TestConnection.to(async (path, request) => room.ask(path, request), { role, key: own });
  return { clock, room, key, connect };
}

it("carries a student, a dashboard and a big screen", async () => {
  const { clock, room, key, connect } = await classWithStudent();
  const student = await connect("learn", key);
  expect(await student.next("welcome")).toMatchObject({ student: 1 });
  const teacher = await connect("teach", room.created.teacherKey);
  expect(await teacher.next("welcome")).toMatchObject({ n: 1 });
  expect(await teacher.next("tiles")).toMatchObject({ tiles: [{ connected: true }] });
  const event = { kind: "opened", lesson: "0a1b2c3d4", task: 1 };
  await student.send({ type: "tile", tile }, { type: "progress", seq: 1, event });
  expect(await student.next("stored")).toMatchObject({ seq: 1 });
  await clock.pass(limits.tilesIntervalMs);
  expect(await teacher.next("student")).toMatchObject({ n: 2, progress: { event } });
  expect(await teacher.next("tiles")).toMatchObject({ tiles: [{ student: 1, tile }] });
  const screen = await connect("show", room.created.screenKey);
  await screen.next("welcome");
  // As large as a message may be, which is more than a response with several messages.
  const content = { runs: "x".repeat(64 * 1024 - 100) };
  await teacher.send({ type: "display", content });
  expect(await screen.next("display")).toMatchObject({ content });
});

it("reports why it closed: the student was removed, replaced, or the class has ended", async () => {
  const { room, key, connect } = await classWithStudent();
  const first = await connect("learn", key);
  const second = await connect("learn", key);
  await expect(first.next("pause")).rejects.toThrow("closed with 4409");
  await room.direct("DELETE", "/students/1");
  await expect(second.next("pause")).rejects.toThrow("closed with 4403");
  const teacher = await connect("teach", room.created.teacherKey);
  await room.direct("DELETE");
  await expect(teacher.next("pause")).rejects.toThrow("closed with 4410");
});

it("opens with the key of its role only", async () => {
  const { room, key } = await classWithStudent();
  const open = async (role: string, own: string) => {
    const body = { type: "hello", version: 1, role, key: own };
    return (await room.ask("/long-poll", { method: "POST", body })).status;
  };
  expect(await open("teach", key)).toBe(403);
  expect(await open("learn", room.created.screenKey)).toBe(403);
  expect(await open("learn", `stu_${"A".repeat(22)}`)).toBe(401);
  await room.direct("DELETE");
  expect(await open("learn", key)).toBe(404);
});
