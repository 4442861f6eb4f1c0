/** The WebSocket of a class, as students, dashboards and big screens use it. */
import {
  relayToScreenSchema,
  relayToStudentSchema,
  relayToTeacherSchema,
} from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { challenge } from "../../platform/testing/sample-documents.ts";
import { ClassAtRelay, tile } from "../../testing/class-at-relay.ts";
import { startTestRelay } from "../../testing/test-relay.ts";

async function classWith(students: number, request: object = {}) {
  const clock = new FakeClock();
  const relay = await startTestRelay({ clock });
  const room = await ClassAtRelay.create(relay, request);
  const joined = [];
  for (let n = 0; n < students; n++) joined.push(await room.join());
  const [ada, bo] = joined;
  if (ada === undefined) throw new Error("there is no student");
  return { clock, relay, room, ada, bo: bo ?? ada };
}

const opened = { kind: "opened", lesson: "0a1b2c3d4", task: 1 };

describe("a student's socket", () => {
  it("begins with the name, the settings and what is stored", async () => {
    const { room, ada } = await classWith(1, { names: ["Ada"] });
    await room.direct("PUT", "/pause", { seconds: 60 });
    await room.direct("PUT", "/pace", { to: 2 });
    const { welcome } = await room.student(ada);
    expect(relayToStudentSchema.parse(welcome)).toMatchObject({
      student: 1,
      name: { word: null, text: "Ada" },
      renamesLeft: 2,
      progress: 0,
      helpWanted: false,
      watched: false,
      pauseEndsInMs: 60_000,
      paceTo: 2,
    });
  });

  it("stores progress once, and programs, which the teacher sees", async () => {
    const { room, ada } = await classWith(1);
    const teacher = await room.teacher();
    const { socket } = await room.student(ada);
    for (const _ of [1, 2]) {
      socket.send({ type: "progress", seq: 1, event: opened });
      expect(await socket.next("stored")).toMatchObject({ what: "progress", seq: 1 });
    }
    const event = relayToTeacherSchema.parse(await teacher.socket.next("student"));
    expect(event).toMatchObject({ n: 2, progress: { seq: 1, event: opened } });
    socket.send({ type: "program", seq: 7, task: 1, link: "c1.AAAA" });
    expect(await socket.next("stored")).toMatchObject({ what: "program", seq: 7 });
    const stored = await (await room.direct("GET", "/students/1/program")).json();
    expect(stored).toMatchObject({ task: 1, link: "c1.AAAA" });
    expect((await room.student(ada)).welcome).toMatchObject({ progress: 1 });
  });

  it("asks for help and withdraws it", async () => {
    const { clock, room, ada } = await classWith(1);
    const teacher = await room.teacher();
    const { socket } = await room.student(ada);
    const at = new Date(clock.now()).toISOString();
    for (const [wanted, helpSince] of [
      [true, at],
      [false, null],
    ]) {
      socket.send({ type: "help", wanted });
      expect(await teacher.socket.next("student")).toMatchObject({ student: { helpSince } });
    }
  });

  it("changes the name twice", async () => {
    const { room, ada } = await classWith(1);
    const { socket } = await room.student(ada);
    for (const renamesLeft of [1, 0]) {
      socket.send({ type: "name" });
      expect(relayToStudentSchema.parse(await socket.next("name"))).toMatchObject({ renamesLeft });
    }
    socket.send({ type: "name" });
    const { problem } = await socket.next("problem");
    expect(problem).toMatchObject({ type: "/problems/no-other-name" });
  });

  it("receives lesson, pause and pace as the teacher sets them", async () => {
    const { room, ada } = await classWith(1);
    const { socket } = await room.student(ada);
    const sent = await room.direct("PUT", "/lesson", challenge);
    const version = sent.headers.get("ETag")?.replaceAll('"', "");
    expect(await socket.next("lesson")).toEqual({ type: "lesson", version });
    await room.direct("PUT", "/pause", { seconds: 60 });
    expect(await socket.next("pause")).toEqual({ type: "pause", endsInMs: 60_000 });
    await room.direct("DELETE", "/pause");
    expect(await socket.next("pause")).toEqual({ type: "pause", endsInMs: null });
    await room.direct("PUT", "/pace", { to: 1 });
    expect(await socket.next("pace")).toEqual({ type: "pace", to: 1 });
  });

  it("closes with 4409 when a second tab takes over, which keeps the student", async () => {
    const { room, ada } = await classWith(1);
    const first = await room.student(ada);
    const second = await room.student(ada);
    expect(await first.socket.closed).toMatchObject({ code: 4409 });
    second.socket.send({ type: "progress", seq: 1, event: opened });
    await second.socket.next("stored");
    const teacher = await room.teacher();
    expect(await teacher.socket.next("tiles")).toMatchObject({ tiles: [{ connected: true }] });
  });

  it("closes with 4409 when the student returns on another device", async () => {
    const { room, ada } = await classWith(1);
    const { socket } = await room.student(ada);
    const answer = await room.direct("POST", "/students/1/return");
    const { code } = (await answer.json()) as { code: string };
    const again = await room.join(code);
    expect(await socket.closed).toMatchObject({ code: 4409 });
    expect((await room.student(again)).welcome).toMatchObject({ student: 1 });
    const old = await room.connect("learn", ada.key);
    expect(await old.closed).toMatchObject({ code: 4401 });
  });

  it("closes with 4403 when the teacher removes the student, and no other closes", async () => {
    const { room, ada, bo } = await classWith(2);
    const removed = await room.student(ada);
    const other = await room.student(bo);
    const teacher = await room.teacher();
    await room.direct("DELETE", "/students/1");
    expect(await removed.socket.closed).toMatchObject({ code: 4403 });
    expect(await teacher.socket.next("removed")).toMatchObject({ student: 1 });
    other.socket.send({ type: "progress", seq: 1, event: opened });
    await other.socket.next("stored");
  });

  it("receives a problem for an invalid or too frequent message, and closes after ten", async () => {
    const { room, ada, bo } = await classWith(2);
    const { socket } = await room.student(ada);
    socket.send({ type: "tile", tile: { ...tile, path: "x".repeat(2_000) } });
    expect(await socket.next("problem")).toMatchObject({ problem: { status: 400 } });
    for (let n = 1; n <= limits.studentRates.tile.burst + 1; n++)
      socket.send({ type: "tile", tile });
    expect(await socket.next("problem")).toMatchObject({ problem: { status: 429 } });
    for (let n = 0; n < limits.badFrames; n++) socket.send(null);
    expect(await socket.closed).toMatchObject({ code: 4400 });
    await room.student(bo);
  });
});

describe("a dashboard's socket", () => {
  it("begins with all students, and then receives each tile", async () => {
    const { clock, room, ada, bo } = await classWith(2);
    const [one] = [await room.student(ada), await room.student(bo)];
    const { socket, welcome } = await room.teacher();
    expect(relayToTeacherSchema.parse(welcome)).toMatchObject({ n: 2 });
    const batch = relayToTeacherSchema.parse(await socket.next("tiles"));
    expect(batch).toMatchObject({
      seq: 1,
      tiles: [1, 2].map((student) => ({ student, connected: true, tile: null })),
    });
    one.socket.send({ type: "tile", tile });
    one.socket.send({ type: "progress", seq: 1, event: opened });
    await one.socket.next("stored");
    await clock.pass(limits.tilesIntervalMs);
    const next = await socket.next("tiles");
    expect(next).toEqual({ type: "tiles", seq: 2, tiles: [{ student: 1, connected: true, tile }] });
  });

  it("receives the tile of a student while another one floods the class with tiles", async () => {
    const { clock, room, ada, bo } = await classWith(2);
    const [flood, calm] = [await room.student(ada), await room.student(bo)];
    const { socket } = await room.teacher();
    await socket.next("tiles");
    for (let seq = 1; seq <= 1_000; seq++) {
      flood.socket.send({ type: "tile", tile: { ...tile, seq } });
    }
    expect(await flood.socket.next("problem")).toMatchObject({ problem: { status: 429 } });
    calm.socket.send({ type: "tile", tile });
    calm.socket.send({ type: "progress", seq: 1, event: opened });
    await calm.socket.next("stored");
    await clock.pass(limits.tilesIntervalMs);
    const batch = relayToTeacherSchema.parse(await socket.next("tiles"));
    const arrived = { student: 2, connected: true, tile };
    expect(batch).toMatchObject({ tiles: expect.arrayContaining([arrived]) });
  });

  it("receives two batches a second at most, and no third before it acknowledges one", async () => {
    const { clock, room, ada } = await classWith(1);
    const { socket } = await room.teacher();
    const student = await room.student(ada);
    const sendTile = async (seq: number): Promise<void> => {
      student.socket.send({ type: "tile", tile: { ...tile, seq } });
      student.socket.send({ type: "progress", seq, event: opened });
      await student.socket.next("stored");
      await clock.pass(limits.tilesIntervalMs);
    };
    expect(await socket.next("tiles")).toMatchObject({ seq: 1 });
    for (let seq = 1; seq <= 4; seq++) await sendTile(seq);
    expect(await socket.next("tiles")).toMatchObject({ seq: 2, tiles: [{ tile: { seq: 1 } }] });
    socket.send({ type: "seen", seq: 1 });
    expect(await socket.next("tiles")).toMatchObject({ seq: 3, tiles: [{ tile: { seq: 4 } }] });
  });

  it("shows that a student disconnects", async () => {
    const { clock, room, ada } = await classWith(1);
    const student = await room.student(ada);
    const { socket } = await room.teacher();
    expect(await socket.next("tiles")).toMatchObject({ tiles: [{ connected: true }] });
    student.socket.close();
    await student.socket.closed;
    await clock.pass(limits.tilesIntervalMs);
    expect(await socket.next("tiles")).toMatchObject({ tiles: [{ connected: false }] });
  });

  it("watches a student, who is notified of its start and end", async () => {
    const { room, ada, bo } = await classWith(2);
    const [watched, other] = [await room.student(ada), await room.student(bo)];
    const { socket } = await room.teacher();
    socket.send({ type: "watch", student: 1 });
    expect(await watched.socket.next("watched")).toMatchObject({ watched: true });
    socket.send({ type: "watch", student: 2 });
    expect(await watched.socket.next("watched")).toMatchObject({ watched: false });
    expect(await other.socket.next("watched")).toMatchObject({ watched: true });
    socket.close();
    expect(await other.socket.next("watched")).toMatchObject({ watched: false });
  });

  it("watches a student, who can then send 5 tiles a second instead of 2", async () => {
    const { clock, room, ada } = await classWith(1);
    const student = await room.student(ada);
    const { socket } = await room.teacher();
    const { tile: unwatched, "watched tile": whileWatched } = limits.studentRates;
    const sendTiles = (count: number): void => {
      for (let n = 1; n <= count; n++) student.socket.send({ type: "tile", tile });
    };
    const expectRefusal = async (perSecond: number): Promise<void> => {
      sendTiles(1);
      const { problem } = await student.socket.next("problem");
      expect(problem).toMatchObject({ detail: expect.stringContaining(`${perSecond} a second`) });
    };
    sendTiles(unwatched.burst);
    await expectRefusal(2);
    socket.send({ type: "watch", student: 1 });
    await student.socket.next("watched");
    sendTiles(whileWatched.burst);
    await expectRefusal(5);
    await clock.pass(1_000);
    sendTiles(whileWatched.perSecond);
    await expectRefusal(5);
    socket.send({ type: "watch", student: null });
    await student.socket.next("watched");
    sendTiles(unwatched.perSecond);
    await expectRefusal(2);
  });

  it("shows a hint to one student", async () => {
    const { room, ada } = await classWith(1);
    const student = await room.student(ada);
    const { socket } = await room.teacher();
    socket.send({ type: "hint", student: 9, task: 1, hint: 2 });
    const { problem } = await socket.next("problem");
    expect(problem).toMatchObject({ type: "/problems/no-student" });
    socket.send({ type: "hint", student: 1, task: 1, hint: 2 });
    expect(await student.socket.next("hint")).toEqual({ type: "hint", task: 1, hint: 2 });
  });

  it("continues after the last event that it received, or reads a gap", async () => {
    const { room } = await classWith(1);
    const { socket, welcome } = await room.teacher();
    socket.close();
    await room.join();
    await room.direct("PUT", "/lock");
    const again = await room.teacher(`${String(welcome["stream"])}-1`);
    expect(again.welcome).toMatchObject({ stream: welcome["stream"], n: 1 });
    const joined = relayToTeacherSchema.parse(await again.socket.next("student"));
    expect(joined).toMatchObject({ n: 2, student: { student: 2 } });
    const settings = relayToTeacherSchema.parse(await again.socket.next("settings"));
    expect(settings).toMatchObject({ n: 3, settings: { locked: true } });
    for (const since of ["AAAAAAAA-1", `${String(welcome["stream"])}-99`]) {
      const other = await room.teacher(since);
      expect(other.welcome).toMatchObject({ n: null });
      expect(relayToTeacherSchema.parse(await other.socket.next("gap"))).toMatchObject({ n: 3 });
    }
  });
});

describe("a big screen's socket", () => {
  it("receives the code, the lesson and what a dashboard displays, and nothing else", async () => {
    const { clock, room, ada } = await classWith(1);
    const teacher = await room.teacher();
    const { socket, welcome } = await room.screen();
    const { code } = room.created;
    expect(relayToScreenSchema.parse(welcome)).toMatchObject({ code });
    const student = await room.student(ada);
    student.socket.send({ type: "help", wanted: true });
    await teacher.socket.next("student");
    await room.direct("POST", "/code");
    const message = await socket.next("code", "student", "tiles", "settings");
    expect(relayToScreenSchema.parse(message).type).toBe("code");
    const content = { solved: 12, runs: "x".repeat(60_000) };
    teacher.socket.send({ type: "display", content });
    expect(await socket.next("display")).toEqual({ type: "display", seq: 1, content });
    teacher.socket.send({ type: "display", content: { solved: 13 } });
    teacher.socket.send({ type: "watch", student: 1 });
    await student.socket.next("watched");
    await clock.pass(limits.displayIntervalMs);
    expect(await socket.next("display")).toMatchObject({ seq: 2, content: { solved: 13 } });
    const late = await room.screen();
    expect(await late.socket.next("display")).toMatchObject({ content: { solved: 13 } });
  });

  it("shows the dashboard with the highest priority, or the newest one without a priority", async () => {
    const { clock, room } = await classWith(1);
    const [laptop, phone] = [await room.teacher(), await room.teacher()];
    const { socket } = await room.screen();
    const show = (from: typeof laptop, solved: number, priority?: number): void =>
      from.socket.send({ type: "display", content: { solved }, priority });
    // The relay handles the messages of one dashboard in their order.
    const isHandled = async (from: typeof laptop): Promise<void> => {
      from.socket.send({ type: "hint", student: 99, task: 1, hint: 1 });
      await from.socket.next("problem");
    };
    const next = async () => {
      await clock.pass(limits.displayIntervalMs);
      const { seq, content } = await socket.next("display");
      socket.send({ type: "seen", seq });
      return content;
    };
    show(laptop, 1, 5);
    expect(await next()).toEqual({ solved: 1 });
    show(phone, 2, -9);
    await isHandled(phone);
    show(laptop, 3, 5);
    expect(await next()).toEqual({ solved: 3 });
    show(phone, 4);
    expect(await next()).toEqual({ solved: 4 });
    show(laptop, 5, 5);
    expect(await next()).toEqual({ solved: 5 });
  });

  it("belongs to one dashboard at a time, and all dashboards know which priority it shows", async () => {
    const { room } = await classWith(1);
    const [laptop, phone] = [await room.teacher(), await room.teacher()];
    const show = (from: typeof laptop, priority?: number): void =>
      from.socket.send({ type: "display", content: {}, priority });
    const expectDisplayed = async (priority: number | null, ...dashboards: (typeof laptop)[]) => {
      for (const { socket } of dashboards)
        expect(await socket.next("displayed")).toEqual({ type: "displayed", priority });
    };
    show(laptop, 5);
    await expectDisplayed(5, laptop, phone);
    // Neither lower content nor more of the same device changes it.
    show(phone, -9);
    show(laptop, 5);
    show(phone, 6);
    await expectDisplayed(6, laptop, phone);
    const late = await room.teacher();
    await expectDisplayed(6, late);
    phone.socket.close();
    await expectDisplayed(null, laptop, late);
    // Content without a priority controls nothing.
    show(laptop);
    show(late, 7);
    await expectDisplayed(7, laptop, late);
  });

  it("connects with dashboards up to a limit of 4", async () => {
    const { room } = await classWith(1);
    for (let n = 0; n < 2; n++) await Promise.all([room.teacher(), room.screen()]);
    for (const [role, key] of [
      ["teach", room.created.teacherKey],
      ["show", room.created.screenKey],
    ] as const) {
      expect(await (await room.connect(role, key)).closed).toMatchObject({ code: 4429 });
    }
  });
});

describe("the socket of a class", () => {
  it("connects each role with its key only", async () => {
    const { relay, room, ada } = await classWith(1);
    const robot = await relay.register();
    const { created } = await ClassAtRelay.create(relay);
    const members = {
      teach: room.created.teacherKey,
      show: room.created.screenKey,
      learn: ada.key,
    };
    const strangers = { robot: robot.ownerKey, other: created.teacherKey };
    for (const role of Object.keys(members)) {
      for (const [holder, key] of Object.entries({ ...members, ...strangers })) {
        if (holder === role) continue;
        const { code } = await (await room.connect(role, key)).closed;
        expect({ role, holder, code }).toEqual({
          role,
          holder,
          code: holder in members ? 4403 : 4401,
        });
      }
    }
  });

  it("closes with 4410 for all members when the teacher ends the class", async () => {
    const { room, ada } = await classWith(1);
    const members = [await room.student(ada), await room.teacher(), await room.screen()];
    await room.direct("DELETE");
    for (const { socket } of members) expect(await socket.closed).toMatchObject({ code: 4410 });
    expect(await (await room.connect("learn", ada.key)).closed).toMatchObject({ code: 4410 });
  });

  it("closes with 4410 when nobody has used the class for 2 hours", async () => {
    const { clock, room, ada } = await classWith(1);
    const { socket } = await room.student(ada);
    for (let hour = 0; hour < 3; hour++) await clock.pass(3_600_000);
    // Silence ends a connection first. A client that reconnects learns why.
    await socket.closed;
    expect(await (await room.connect("learn", ada.key)).closed).toMatchObject({ code: 4410 });
  });

  it("closes with 1012 when the relay shuts down", async () => {
    const { relay, room, ada } = await classWith(1);
    const { socket } = await room.student(ada);
    await relay.close();
    expect(await socket.closed).toMatchObject({ code: 1012 });
  });
});
