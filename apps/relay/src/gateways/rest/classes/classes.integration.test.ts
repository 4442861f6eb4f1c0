import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import {
  classViewSchema,
  createdClassSchema,
  joinedClassSchema,
  MAX_DOCUMENT_BYTES,
  returnCodeSchema,
  type CreatedClass,
  type JoinedClass,
} from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { classRights, type ClassVerb } from "../../../classes/access.ts";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { challenge, lesson } from "../../../platform/testing/sample-documents.ts";
import { startTestRelay, testFolder, type TestRelay } from "../../../testing/test-relay.ts";

const HOUR_MS = 3_600_000;

interface Ask {
  method?: string;
  key?: string;
  body?: unknown;
  headers?: Record<string, string>;
}

function clientOf({ origin }: TestRelay) {
  const ask = (path: string, { method = "GET", key, body, headers }: Ask = {}) =>
    fetch(`${origin}/api/v1${path}`, {
      method,
      headers: {
        ...(key !== undefined && { Authorization: `Bearer ${key}` }),
        ...(body !== undefined && { "Content-Type": "application/json" }),
        ...headers,
      },
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
  const create = async (request: object = {}): Promise<CreatedClass> => {
    const answer = await ask("/classes", { method: "POST", body: { lesson, ...request } });
    return createdClassSchema.parse(await answer.json());
  };
  const tryJoin = (code: string) => ask("/joins", { method: "POST", body: { code } });
  const joinWith = async (code: string): Promise<JoinedClass> =>
    joinedClassSchema.parse(await (await tryJoin(code)).json());
  const view = async ({ id, teacherKey }: CreatedClass) =>
    classViewSchema.parse(await (await ask(`/classes/${id}`, { key: teacherKey })).json());
  const problemOf = async (answer: Promise<Response>): Promise<string> => {
    const { status, type } = (await (await answer).json()) as { status: number; type: string };
    return `${status} ${type.replace("/problems/", "")}`;
  };
  return { ask, create, tryJoin, join: joinWith, view, problemOf };
}

async function relayWithClass(request: object = {}) {
  const dataDir = testFolder();
  const clock = new FakeClock();
  const relay = await startTestRelay({ dataDir, clock });
  const client = clientOf(relay);
  const created = await client.create(request);
  const own = { key: created.teacherKey };
  const direct = (method: string, path: string, body?: unknown) =>
    client.ask(`/classes/${created.id}${path}`, { method, ...own, body });
  const holds = (text: string): boolean =>
    readdirSync(dataDir).some((file) => readFileSync(join(dataDir, file)).includes(text));
  return { ...client, relay, clock, created, own, direct, holds };
}

describe("a class", () => {
  it("is created with a code, keys and the address of its dashboard", async () => {
    const { relay, created } = await relayWithClass();
    expect(created.teacherKey).toMatch(/^tea_/);
    expect(created.screenKey).toMatch(/^scr_/);
    expect(created.address).toBe(`${relay.origin}/class/${created.id}#${created.teacherKey}`);
    expect(created.endsInSeconds).toBe(12 * 3_600);
  });

  it("admits students by its code, whom the teacher sees", async () => {
    const { created, join, view } = await relayWithClass({ names: ["Ada"] });
    const code = `${created.code.slice(0, 3)} ${created.code.slice(3).toLowerCase()}`;
    const joined = await join(code);
    const name = { word: null, text: "Ada" };
    expect(joined).toMatchObject({ class: created.id, student: 1, name });
    expect(joined.key).toMatch(/^stu_/);
    expect(await view(created)).toMatchObject({
      id: created.id,
      settings: { code: created.code, locked: false, pauseEndsInMs: null, paceTo: null },
      students: [{ student: 1, name, renamesLeft: 2, helpSince: null, programs: 0, progress: [] }],
    });
  });

  it("admits 200 students of one address at once, each with another name, and no more", async () => {
    const { created, join, tryJoin, problemOf } = await relayWithClass();
    const joined = await Promise.all(Array.from({ length: 200 }, () => join(created.code)));
    expect(new Set(joined.map(({ student }) => student)).size).toBe(200);
    expect(new Set(joined.map(({ name }) => name.word)).size).toBe(200);
    expect(await problemOf(tryJoin(created.code))).toBe("429 too-fast");
  });

  it("rejects a wrong code, a locked class and a full one", async () => {
    const room = await relayWithClass({ names: ["Ada"] });
    const { clock, created, join, tryJoin, direct, problemOf } = room;
    const wrong = created.code === "BBBBBB" ? "CCCCCC" : "BBBBBB";
    expect(await problemOf(tryJoin(wrong))).toBe("404 no-class");
    await clock.pass(1_000);
    expect((await direct("PUT", "/lock")).status).toBe(204);
    expect(await problemOf(tryJoin(created.code))).toBe("409 class-locked");
    expect((await direct("DELETE", "/lock")).status).toBe(204);
    await join(created.code);
    expect(await problemOf(tryJoin(created.code))).toBe("409 class-full");
  });

  it("replaces its code", async () => {
    const { clock, created, join, tryJoin, direct, view, problemOf } = await relayWithClass();
    const answer = await direct("POST", "/code");
    expect(answer.status).toBe(201);
    const { code } = (await answer.json()) as { code: string };
    expect(await problemOf(tryJoin(created.code))).toBe("404 no-class");
    await clock.pass(1_000);
    expect((await join(code)).student).toBe(1);
    expect((await view(created)).settings.code).toBe(code);
  });

  it("pauses until the relay's clock ends the pause", async () => {
    const { clock, created, direct, view } = await relayWithClass();
    expect((await direct("PUT", "/pause", { seconds: 60 })).status).toBe(204);
    await clock.pass(20_000);
    expect((await view(created)).settings.pauseEndsInMs).toBe(40_000);
    await clock.pass(40_000);
    expect((await view(created)).settings.pauseEndsInMs).toBeNull();
    await direct("PUT", "/pause", { seconds: 60 });
    expect((await direct("DELETE", "/pause")).status).toBe(204);
    expect((await view(created)).settings.pauseEndsInMs).toBeNull();
    expect((await direct("PUT", "/pause", { seconds: 9 })).status).toBe(400);
  });

  it("opens tasks up to a number", async () => {
    const { created, direct, view } = await relayWithClass();
    expect((await direct("PUT", "/pace", { to: 2 })).status).toBe(204);
    expect((await view(created)).settings.paceTo).toBe(2);
    expect((await direct("DELETE", "/pace")).status).toBe(204);
    expect((await view(created)).settings.paceTo).toBeNull();
  });

  it("shows its lesson to all members, with a version, and replaces it", async () => {
    const { created, join, ask, direct } = await relayWithClass();
    const { key } = await join(created.code);
    const path = `/classes/${created.id}/lesson`;
    for (const each of [created.teacherKey, created.screenKey, key]) {
      expect(await (await ask(path, { key: each })).json()).toEqual(lesson);
    }
    const tag = (await ask(path, { key })).headers.get("ETag") ?? "";
    const cached = await ask(path, { key, headers: { "If-None-Match": tag } });
    expect(cached.status).toBe(304);
    const sent = await direct("PUT", "/lesson", challenge);
    expect(sent.status).toBe(204);
    const next = await ask(path, { key, headers: { "If-None-Match": tag } });
    expect(next.headers.get("ETag")).toBe(sent.headers.get("ETag"));
    expect(await next.json()).toEqual(challenge);
  });

  it.each([
    { what: "a newer version", body: { ...lesson, version: 3 }, status: 400 },
    {
      what: "13 tasks",
      body: { ...lesson, tasks: Array.from({ length: 13 }, () => lesson.tasks[0]) },
      status: 400,
    },
    {
      what: "more than 64 KiB",
      body: { ...lesson, intro: "x".repeat(MAX_DOCUMENT_BYTES) },
      status: 413,
    },
  ])("rejects a lesson of $what", async ({ body, status }) => {
    const { ask, direct } = await relayWithClass();
    expect((await direct("PUT", "/lesson", body)).status).toBe(status);
    const created = await ask("/classes", { method: "POST", body: { lesson: body } });
    expect(created.status).toBe(status);
  });

  it("lets a student return once on another device, whose key replaces the old one", async () => {
    const { created, join, tryJoin, ask, direct, problemOf } = await relayWithClass();
    const first = await join(created.code);
    await direct("PUT", "/lock");
    const answer = await direct("POST", `/students/${first.student}/return`);
    const { code } = returnCodeSchema.parse(await answer.json());
    const again = await join(code);
    expect(again).toMatchObject({ student: first.student, name: first.name });
    const path = `/classes/${created.id}/lesson`;
    expect((await ask(path, { key: again.key })).status).toBe(200);
    expect((await ask(path, { key: first.key })).status).toBe(401);
    expect(await problemOf(tryJoin(code))).toBe("404 no-class");
  });

  it("lets no student return after the 10 minutes of the code", async () => {
    const { clock, created, join, tryJoin, direct, problemOf } = await relayWithClass();
    const first = await join(created.code);
    const answer = await direct("POST", `/students/${first.student}/return`);
    const { code, endsInSeconds } = returnCodeSchema.parse(await answer.json());
    await clock.pass(endsInSeconds * 1_000);
    expect(await problemOf(tryJoin(code))).toBe("404 no-class");
  });

  it("removes a student, whose key and number are invalid from then on", async () => {
    const { created, join, ask, direct, view, problemOf } = await relayWithClass();
    const { key } = await join(created.code);
    expect(await problemOf(direct("GET", "/students/1/program"))).toBe("404 no-program");
    expect((await direct("DELETE", "/students/1")).status).toBe(204);
    expect((await ask(`/classes/${created.id}/lesson`, { key })).status).toBe(401);
    expect(await problemOf(direct("DELETE", "/students/1"))).toBe("404 no-student");
    expect(await problemOf(direct("GET", "/students/1/program"))).toBe("404 no-student");
    expect((await view(created)).students).toEqual([]);
    expect((await join(created.code)).student).toBe(2);
  });

  it.each([
    {
      when: "the teacher ends it",
      end: async ({ direct }: Awaited<ReturnType<typeof relayWithClass>>) =>
        expect((await direct("DELETE", "")).status).toBe(204),
    },
    {
      when: "nobody has used it for 2 hours",
      end: async ({ clock }: Awaited<ReturnType<typeof relayWithClass>>) =>
        clock.pass(2 * HOUR_MS + 120_000),
    },
    {
      when: "it is 12 hours old, in spite of its use",
      end: async ({ clock, direct }: Awaited<ReturnType<typeof relayWithClass>>) => {
        for (let hour = 0; hour < 12; hour++) {
          expect((await direct("GET", "")).status).toBe(200);
          await clock.pass(HOUR_MS);
        }
        await clock.pass(120_000);
      },
    },
  ])("leaves nothing in files when $when", async ({ end }) => {
    const room = await relayWithClass({ names: ["Juniper the first", "Bo"] });
    const { created, join, tryJoin, ask, own, holds, problemOf } = room;
    const { key } = await join(created.code);
    expect(holds("Juniper the first")).toBe(true);
    await end(room);
    expect(await problemOf(ask(`/classes/${created.id}`, own))).toBe("404 no-class");
    expect(await problemOf(ask(`/classes/${created.id}/lesson`, { key }))).toBe("404 no-class");
    for (const text of ["Juniper the first", created.id, created.code, lesson.name]) {
      expect(holds(text)).toBe(false);
    }
    expect(await problemOf(tryJoin(created.code))).toBe("404 no-class");
  });

  it("is stored with all students before they are admitted", async () => {
    const dataDir = testFolder();
    const first = await startTestRelay({ dataDir });
    const created = await clientOf(first).create();
    const joined = await clientOf(first).join(created.code);
    await first.close();
    const second = clientOf(await startTestRelay({ dataDir }));
    expect((await second.view(created)).students).toMatchObject([{ student: joined.student }]);
    expect((await second.join(created.code)).student).toBe(2);
  });

  it("limits classes to 20 at once for each address", async () => {
    const { create, ask, clock, problemOf } = await relayWithClass();
    for (let n = 2; n <= 20; n++) await create();
    const more = () => ask("/classes", { method: "POST", body: { lesson } });
    expect(await problemOf(more())).toBe("429 too-fast");
    await clock.pass(10_000);
    expect((await more()).status).toBe(201);
  });
});

/** Endpoints by the permission that they require. */
const calls: { verb: ClassVerb; method: string; path: string; body?: unknown }[] = [
  { verb: "inspect", method: "GET", path: "" },
  { verb: "inspect", method: "GET", path: "/students/1/program" },
  { verb: "readLesson", method: "GET", path: "/lesson" },
  { verb: "direct", method: "PUT", path: "/lesson", body: challenge },
  { verb: "direct", method: "PUT", path: "/pause", body: { seconds: 10 } },
  { verb: "direct", method: "DELETE", path: "/pause" },
  { verb: "direct", method: "PUT", path: "/pace", body: { to: 1 } },
  { verb: "direct", method: "DELETE", path: "/pace" },
  { verb: "direct", method: "PUT", path: "/lock" },
  { verb: "direct", method: "DELETE", path: "/lock" },
  { verb: "direct", method: "POST", path: "/code" },
  { verb: "direct", method: "POST", path: "/students/1/return" },
  { verb: "direct", method: "DELETE", path: "/students/9" },
  { verb: "end", method: "DELETE", path: "" },
];

describe("permissions in a class", () => {
  it.each(calls)("$method $path", async ({ verb, method, path, body }) => {
    const { relay, created, create, join, ask } = await relayWithClass();
    const other = await create();
    const robot = await relay.register();
    const { key: learn } = await join(created.code);
    const strangers = {
      none: undefined,
      unknown: `tea_${"A".repeat(22)}`,
      "of another class": other.teacherKey,
      "of a robot": robot.ownerKey,
      "the code": created.code,
    };
    const members = { learn, show: created.screenKey, teach: created.teacherKey };
    const found: Record<string, unknown> = {};
    for (const [holder, key] of Object.entries({ ...strangers, ...members })) {
      const request = { method, body, ...(key !== undefined && { key }) };
      const { status } = await ask(`/classes/${created.id}${path}`, request);
      // With permission, the response is that there is no such student or program.
      found[holder] = status < 300 || status === 404 ? "yes" : status;
    }
    const kinds: readonly string[] = classRights[verb];
    const expected = Object.keys(members).map((kind) => [kind, kinds.includes(kind) ? "yes" : 403]);
    expect(found).toEqual({
      ...Object.fromEntries(Object.keys(strangers).map((holder) => [holder, 401])),
      ...Object.fromEntries(expected),
    });
  });
});
