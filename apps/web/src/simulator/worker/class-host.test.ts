import { closeReasons, type SocketEvents } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ClassHint, ClassSession } from "../protocol/class-messages.ts";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { ClassHost } from "./class-host.ts";
import { RunLoop } from "./run-loop.ts";

const NOW = Date.UTC(2026, 0, 1);
const open = { kind: "open", id: "A".repeat(22), key: `stu_${"B".repeat(22)}` } as const;
const name = { word: 17, text: null };
const welcome = {
  type: "welcome",
  version: 1,
  student: 3,
  name,
  renamesLeft: 2,
  progress: 0,
  helpWanted: false,
  watched: false,
  pauseEndsInMs: null,
  paceTo: null,
  lesson: "k3J9x2aBk3J9x2aBk3J9x2",
};

/** The worker's end of a class, at a relay whose messages the test controls. */
function newHost() {
  const sockets: { events: SocketEvents; sent: unknown[] }[] = [];
  const sessions: ClassSession[] = [];
  const hints: ClassHint[] = [];
  const loop = new RunLoop(firstMaze, firstProgram, () => 0);
  const timers = new Set<{ ms: number; call: () => void }>();
  const after = (ms: number, call: () => void) => {
    const timer = { ms, call };
    timers.add(timer);
    return () => void timers.delete(timer);
  };
  const host = new ClassHost({
    origin: "http://localhost",
    now: () => NOW,
    run: () => loop,
    onSession: (session) => sessions.push(session),
    onHint: (hint) => hints.push(hint),
    after,
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
    sockets,
    receive,
    session: () => sessions.at(-1),
    hints,
    /** messages of the newest connection, without `hello` */
    sent: () => sockets.at(-1)?.sent.slice(1),
    accept: (): void => {
      sockets.at(-1)?.events.opened();
      receive(welcome);
    },
    close: (code: number) => sockets.at(-1)?.events.closed(code),
    /** Calls all timers of at most a second. */
    passSecond: (): void => {
      const due = [...timers].filter(({ ms }) => ms <= 1_000);
      for (const timer of due) timers.delete(timer);
      for (const { call } of due) call();
    },
  };
}

/** A host whose student is connected. */
function inClass() {
  const opened = newHost();
  opened.host.handle(open);
  opened.accept();
  return opened;
}

describe("a student's connection in the worker", () => {
  it("reports the student once it is connected", () => {
    const { host, session, accept } = newHost();
    host.handle(open);
    expect(session()).toEqual({ status: { kind: "connecting" }, student: null });
    accept();
    expect(session()).toEqual({
      status: { kind: "connected" },
      student: {
        name,
        renamesLeft: 2,
        rename: "possible",
        helpWanted: false,
        watched: false,
        pauseEndsAt: null,
        lesson: welcome.lesson,
        paceTo: null,
        stored: { progress: 0, program: 0 },
      },
    });
  });

  it("reports that the teacher watches, and stops", () => {
    const { receive, session } = inClass();
    receive({ type: "watched", watched: true });
    expect(session()?.student?.watched).toBe(true);
    receive({ type: "watched", watched: false });
    expect(session()?.student?.watched).toBe(false);
  });

  it("reports a pause with its end, also one that began before it connected", () => {
    const { host, sockets, receive, session, close } = inClass();
    receive({ type: "pause", endsInMs: 60_000 });
    expect(session()?.student?.pauseEndsAt).toBe(NOW + 60_000);
    receive({ type: "pause", endsInMs: null });
    expect(session()?.student?.pauseEndsAt).toBeNull();
    close(1006);
    host.handle(open);
    sockets.at(-1)?.events.opened();
    receive({ ...welcome, pauseEndsInMs: 30_000 });
    expect(session()?.student?.pauseEndsAt).toBe(NOW + 30_000);
  });

  it("keeps the student through a lost connection, and reconnects at once if asked to", () => {
    const { host, sockets, session, accept, close } = inClass();
    close(1006);
    expect(session()).toMatchObject({ status: { kind: "lost" }, student: { renamesLeft: 2 } });
    host.handle(open);
    accept();
    expect(sockets).toHaveLength(2);
    expect(session()?.status).toEqual({ kind: "connected" });
  });

  it.each([
    { reason: "removed", code: closeReasons.forbidden.code },
    { reason: "removed", code: closeReasons.notAuthorised.code },
    { reason: "replaced", code: closeReasons.replaced.code },
    { reason: "over", code: closeReasons.over.code },
  ])("ends with $reason at close code $code, and connects again only if asked to", (ending) => {
    const { host, sockets, session, accept, close } = inClass();
    close(ending.code);
    expect(session()?.status).toEqual({ kind: "over", reason: ending.reason });
    expect(sockets).toHaveLength(1);
    host.handle(open);
    accept();
    expect(session()?.status).toEqual({ kind: "connected" });
  });

  it("reports a new lesson, the pace, hints, and what is stored", () => {
    const { receive, session, hints } = inClass();
    const version = "m".repeat(22);
    receive({ type: "lesson", version });
    receive({ type: "pace", to: 2 });
    receive({ type: "stored", what: "progress", seq: 4 });
    receive({ type: "stored", what: "program", seq: 9 });
    receive({ type: "hint", task: 1, hint: 2 });
    const stored = { progress: 4, program: 9 };
    expect(session()?.student).toMatchObject({ lesson: version, paceTo: 2, stored });
    expect(hints).toEqual([{ task: 1, hint: 2 }]);
  });

  it("sends tiles and reports while it is connected", () => {
    const { host, sent, accept, close } = inClass();
    const event = { kind: "opened", lesson: "0a1b2c3d4", task: 1 } as const;
    const report = { type: "progress", seq: 1, event } as const;
    host.handle({
      kind: "place",
      place: { task: 1, maze: "g1", passes: null, isSolved: false, isDriven: false },
    });
    host.handle({ kind: "send", report });
    host.update(false);
    expect(sent()).toEqual([report, { type: "tile", tile: expect.objectContaining({ seq: 1 }) }]);
    close(1006);
    host.update(true);
    host.handle({ ...open });
    accept();
    expect(sent()).toEqual([]);
  });

  it("closes without a report", () => {
    const { host, session, receive } = inClass();
    host.handle({ kind: "close" });
    receive({ type: "watched", watched: true });
    expect(session()?.student?.watched).toBe(false);
  });
});

describe("a request for help", () => {
  it("ends when the teacher shows a hint", () => {
    const { host, receive, sent, session, passSecond } = inClass();
    host.handle({ kind: "help", wanted: true });
    receive({ type: "hint", task: 1, hint: 1 });
    expect(session()?.student?.helpWanted).toBe(false);
    passSecond();
    expect(sent()).toEqual([
      { type: "help", wanted: true },
      { type: "help", wanted: false },
    ]);
  });

  it("is sent at once", () => {
    const { host, sent, session } = inClass();
    host.handle({ kind: "help", wanted: true });
    expect(session()?.student?.helpWanted).toBe(true);
    expect(sent()).toEqual([{ type: "help", wanted: true }]);
  });

  it("is sent at most once a second, and the newest one always", () => {
    const { host, sent, passSecond } = inClass();
    for (const wanted of [true, false, true, false]) host.handle({ kind: "help", wanted });
    expect(sent()).toEqual([{ type: "help", wanted: true }]);
    passSecond();
    passSecond();
    expect(sent()).toEqual([
      { type: "help", wanted: true },
      { type: "help", wanted: false },
    ]);
  });

  it("changes nothing without a connection", () => {
    const { host, session, close } = inClass();
    close(1006);
    host.handle({ kind: "help", wanted: true });
    expect(session()?.student?.helpWanted).toBe(false);
  });
});

describe("another name", () => {
  it("arrives with the number of changes that are left", () => {
    const { host, sent, receive, session } = inClass();
    host.handle({ kind: "name" });
    expect(sent()).toEqual([{ type: "name" }]);
    expect(session()?.student?.rename).toBe("requested");
    const next = { word: 18, text: null };
    receive({ type: "name", name: next, renamesLeft: 1 });
    expect(session()?.student).toMatchObject({ name: next, renamesLeft: 1, rename: "possible" });
  });

  it.each([
    { type: "/problems/no-other-name", rename: "refused" },
    { type: "/problems/storage-full", rename: "possible" },
  ])("is $rename after $type", ({ type, rename }) => {
    const { host, receive, session } = inClass();
    host.handle({ kind: "name" });
    const problem = { type, title: "Title", status: 409, detail: "Why", errors: [] };
    receive({ type: "problem", problem });
    expect(session()?.student).toMatchObject({ name, rename });
  });
});
