import { lessonMark } from "@corridor/challenge";
import { closeReasons, type SocketEvents } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { FromClassroom } from "../protocol/classroom-messages.ts";
import { ClassroomHost } from "./classroom-host.ts";
import { classView, record, studentView } from "./testing/class-of.ts";
import { lesson } from "../testing/straight-lesson.ts";

const NOW = Date.UTC(2026, 0, 1, 8, 10, 2);
const room = { id: "A".repeat(22), key: `tea_${"B".repeat(22)}` };
const STREAM = "k3J9x2aB";
type Answer = { status: number; text: string };

/** A dashboard's host, at a relay whose responses the test controls. */
function newHost(class_: Answer = { status: 200, text: JSON.stringify(classView()) }) {
  const sockets: { events: SocketEvents; sent: unknown[] }[] = [];
  const posts: FromClassroom[] = [];
  const timers: (() => void)[] = [];
  const reads: string[] = [];
  const relay = { class: class_ };
  const after = (_ms: number, call: () => void) => {
    timers.push(call);
    return () => void timers.splice(timers.indexOf(call), 1);
  };
  const host = new ClassroomHost(room, {
    origin: "http://localhost",
    now: () => NOW,
    after,
    read: async (path) => {
      reads.push(path);
      await Promise.resolve();
      const found = { status: 200, text: JSON.stringify(lesson) };
      return path.endsWith("/lesson") ? found : relay.class;
    },
    post: (message) => posts.push(message),
    onTiles: () => undefined,
    platform: {
      clock: { now: () => 0, after },
      random: () => 0.5,
      connect: (_url, events) => {
        const sent: unknown[] = [];
        sockets.push({ events, sent });
        return {
          send: (text) => void sent.push(JSON.parse(text)),
          close: () => undefined,
          isOpen: true,
          waitingBytes: 0,
        };
      },
    },
  });
  const receive = (message: unknown): void =>
    sockets.at(-1)?.events.received(JSON.stringify(message));
  return {
    host,
    relay,
    reads,
    sockets,
    receive,
    welcome: (n: number | null): void => {
      sockets.at(-1)?.events.opened();
      const { settings } = classView();
      receive({ type: "welcome", version: 1, stream: STREAM, n, settings });
    },
    posted: <Type extends FromClassroom["type"]>(type: Type) =>
      posts.filter((each): each is Extract<FromClassroom, { type: Type }> => each.type === type),
    /** Calls all timers that wait now. */
    pass: (): void => {
      for (const call of timers.splice(0)) call();
    },
    settled: async (): Promise<void> => {
      for (let turn = 0; turn < 20; turn++) await Promise.resolve();
    },
  };
}

const joined = (n: number, student: number) => ({
  type: "student",
  n,
  student: studentView(student),
  progress: null,
});

describe("the host of a dashboard", () => {
  it("reads the class and its lesson, and then follows the events after it", async () => {
    const { settled, sockets, posted, welcome, receive, pass } = newHost();
    await settled();
    welcome(4);
    expect(sockets[0]?.sent).toMatchObject([{ role: "teach", since: "k3J9x2aB-4" }]);
    expect(posted("lesson")).toMatchObject([{ lesson: { name: "Sensors" } }]);
    expect(posted("status").at(-1)).toEqual({ type: "status", status: { kind: "connected" } });
    expect(posted("state").at(-1)?.state).toMatchObject({
      expected: 24,
      createdAt: NOW - 600_000,
      time: { activeMs: 600_000, ahead: 2_000 },
    });
    receive(joined(5, 1));
    pass();
    expect(posted("students").at(-1)).toMatchObject({ changed: [{ student: 1 }] });
  });

  it("reads the class again after a gap, and loses no event meanwhile", async () => {
    const { settled, relay, posted, welcome, receive, pass } = newHost();
    await settled();
    welcome(4);
    const students = [{ ...studentView(1), progress: [] }];
    relay.class = {
      status: 200,
      text: JSON.stringify(classView(students, { since: `${STREAM}-9` })),
    };
    receive({ type: "gap", n: 8 });
    // One event is older than the class that was read, the other one is newer.
    receive({ type: "removed", n: 9, student: 1 });
    receive(joined(10, 2));
    await settled();
    pass();
    const { changed } = posted("students").at(-1) ?? { changed: [] };
    expect(changed.map(({ student }) => student)).toEqual([1, 2]);
  });

  it("reads the class once more after a gap that arrives while it is read", async () => {
    const { settled, relay, reads, posted, welcome, receive, pass } = newHost();
    await settled();
    welcome(4);
    const readings = () => reads.filter((path) => !path.endsWith("/lesson")).length;
    const classAt = (n: number, student: number) => {
      const students = [{ ...studentView(student), progress: [] }];
      return {
        status: 200,
        text: JSON.stringify(classView(students, { since: `${STREAM}-${n}` })),
      };
    };
    relay.class = classAt(9, 1);
    receive({ type: "gap", n: 8 });
    await Promise.resolve();
    receive({ type: "gap", n: 20 });
    await Promise.resolve();
    relay.class = classAt(21, 2);
    await settled();
    pass();
    expect(
      posted("students")
        .at(-1)
        ?.changed.map(({ student }) => student),
    ).toContain(2);
    expect(readings()).toBe(3);
  });

  it("reads a lesson that the teacher sends from another device", async () => {
    const { settled, reads, welcome, receive } = newHost();
    await settled();
    welcome(4);
    const settings = { ...classView().settings, lesson: "a".repeat(22) };
    receive({ type: "settings", n: 5, settings });
    receive({ type: "settings", n: 6, settings });
    await settled();
    expect(reads.filter((path) => path.endsWith("/lesson"))).toHaveLength(2);
  });

  it("has no work of a lesson that the class had before", async () => {
    const openedIn = (lesson: string) => [record(1, 1_000, { kind: "opened", lesson, task: 1 })];
    const students = [
      { ...studentView(1), progress: openedIn("0123456ab") },
      { ...studentView(2), progress: openedIn(lessonMark(lesson)) },
    ];
    const { settled, posted, pass } = newHost({
      status: 200,
      text: JSON.stringify(classView(students)),
    });
    await settled();
    pass();
    const { changed } = posted("students").at(-1) ?? { changed: [] };
    expect(changed).toMatchObject([
      { student: 1, tasks: [] },
      { student: 2, tasks: [{ task: 1 }] },
    ]);
  });

  it.each([
    { status: 404, kind: "over" },
    { status: 401, kind: "refused" },
  ])("reports $kind if the relay answers $status", async ({ status, kind }) => {
    const { settled, posted, sockets } = newHost({ status, text: "{}" });
    await settled();
    expect(posted("status").at(-1)).toMatchObject({ status: { kind } });
    expect(sockets).toEqual([]);
  });

  it("watches the same student after the connection was lost", async () => {
    const { host, settled, sockets, welcome, pass } = newHost();
    await settled();
    welcome(4);
    host.send({ type: "watch", student: 7 });
    sockets[0]?.events.closed(1006);
    pass();
    welcome(4);
    expect(sockets).toHaveLength(2);
    expect(sockets[1]?.sent).toContainEqual({ type: "watch", student: 7 });
  });

  it("tries again while there is no network", async () => {
    const { settled, relay, posted, pass } = newHost({ status: 503, text: "" });
    await settled();
    expect(posted("status").at(-1)).toMatchObject({ status: { kind: "lost" } });
    relay.class = { status: 200, text: JSON.stringify(classView()) };
    pass();
    await settled();
    expect(posted("state")).toHaveLength(1);
  });

  it("reports that the class has ended", async () => {
    const { settled, posted, welcome, sockets } = newHost();
    await settled();
    welcome(4);
    sockets[0]?.events.closed(closeReasons.over.code);
    expect(posted("status").at(-1)).toMatchObject({ status: { kind: "over" } });
  });
});
