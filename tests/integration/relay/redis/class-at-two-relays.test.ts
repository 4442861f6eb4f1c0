import type { JoinedClass } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { ClassAtRelay, tile } from "../../../../apps/relay/src/testing/class-at-relay.ts";
import type { Message, TestSocket } from "../../../../apps/relay/src/testing/test-socket.ts";
import { startTestRelay } from "../../../../apps/relay/src/testing/test-relay.ts";
import { startRelayProcess } from "../../../support/test-relay-process.ts";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";

const STUDENTS = 20;

describe.skipIf(!hasRedis)("a class at two relays with Redis", () => {
  it("loses no acknowledged join, progress or program when a relay is killed", async () => {
    const { url } = await startTestRedis(["--appendfsync", "always"]);
    const environment = { STORE_URL: url };
    const killed = await startRelayProcess({ environment });
    const { origin } = await startTestRelay({ config: { storeUrl: url } });
    const first = await ClassAtRelay.create({ origin: killed.url });
    const second = first.at({ origin });
    const teacher = (await second.teacher()).socket;
    const joined = await Promise.all(Array.from({ length: STUDENTS }, () => first.join()));
    await Promise.all(joined.map(async (student) => work(first, student)));
    await tileOf(teacher, 1);
    await killed.kill();

    for (const student of joined) {
      const { welcome } = await second.student(student);
      expect(welcome).toMatchObject({ student: student.student, progress: 1 });
    }
    const { students } = (await (await second.direct("GET")).json()) as { students: object[] };
    expect(students).toHaveLength(STUDENTS);
    expect(students).toMatchObject(joined.map(() => ({ progress: [{ seq: 1 }], programs: 1 })));
    expect(await second.join()).toMatchObject({ student: STUDENTS + 1 });
  });
});

/** A student's first steps, which the relay acknowledges. */
async function work(room: ClassAtRelay, student: JoinedClass): Promise<void> {
  const { socket } = await room.student(student);
  socket.send({ type: "tile", tile });
  socket.send({
    type: "progress",
    seq: 1,
    event: { kind: "opened", lesson: "0a1b2c3d4", task: 1 },
  });
  await socket.next("stored");
  socket.send({ type: "program", seq: 1, task: 1, link: "c1.AAAA" });
  await socket.next("stored");
}

/** Acknowledges tiles until there is one of this student. */
async function tileOf(teacher: TestSocket, student: number): Promise<Message> {
  for (;;) {
    const message = await teacher.next("tiles");
    teacher.send({ type: "seen", seq: message["seq"] });
    const tiles = message["tiles"] as { student: number; tile: unknown }[];
    if (tiles.some((each) => each.student === student && each.tile !== null)) return message;
  }
}
