/** The time to solve, from the relay's clock: a page reports what happened, not when. */
import { classViewSchema, type Progress } from "@corridor/protocol";
import { expect, it } from "vitest";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { ClassAtRelay } from "../testing/class-at-relay.ts";
import { startTestRelay } from "../testing/test-relay.ts";

const opened: Progress = { kind: "opened", lesson: "0123456ab", task: 1 };
const solved: Progress = { kind: "solved", task: 1, lines: 2, code: "1Qk3" };

it("the time from opening a task to its solution has no pauses, ended or expired", async () => {
  const clock = new FakeClock();
  const relay = await startTestRelay({ clock });
  const room = await ClassAtRelay.create(relay);
  const { socket } = await room.student(await room.join());
  const report = async (seq: number, event: Progress): Promise<void> => {
    socket.send({ type: "progress", seq, event });
    await socket.next("stored");
  };
  const pause = async (seconds: number) => room.direct("PUT", "/pause", { seconds });
  await clock.pass(5_000);
  await report(1, opened);
  await clock.pass(4_000);
  // This pause ends by the clock, after 10 of 15 seconds.
  await pause(10);
  await clock.pass(15_000);
  // The teacher ends this one after 3 of 60 seconds.
  await pause(60);
  await clock.pass(3_000);
  await room.direct("DELETE", "/pause");
  await clock.pass(2_000);
  await report(2, solved);
  const view = classViewSchema.parse(await (await room.direct("GET")).json());
  const times = view.students[0]?.progress.map(({ activeMs }) => activeMs) ?? [];
  expect(times).toEqual([5_000, 5_000 + 4_000 + 5_000 + 2_000]);
});
