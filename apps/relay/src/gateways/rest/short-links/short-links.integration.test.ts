import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { MAX_DOCUMENT_BYTES, problemSchema, shortLinkSchema } from "@corridor/protocol";
import { describe, expect, it, vi } from "vitest";
import { badDocuments } from "../../../testing/bad-documents.ts";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import {
  challenge,
  lesson,
  maze,
  program,
  project,
} from "../../../platform/testing/sample-documents.ts";
import { startTestRelay, testFolder, type TestRelay } from "../../../testing/test-relay.ts";

function post({ origin }: TestRelay, body: unknown, headers: Record<string, string> = {}) {
  return fetch(`${origin}/api/v1/mazes`, {
    method: "POST",
    headers: { "Content-Type": "application/json", ...headers },
    body: typeof body === "string" ? body : JSON.stringify(body),
  });
}

async function store(relay: TestRelay, document: unknown) {
  const answer = await post(relay, document);
  expect(answer.status).toBe(201);
  return shortLinkSchema.parse(await answer.json());
}

function get({ origin }: TestRelay, id: string): Promise<Response> {
  return fetch(`${origin}/api/v1/mazes/${id}`);
}

function remove({ origin }: TestRelay, id: string, key?: string): Promise<Response> {
  return fetch(`${origin}/api/v1/mazes/${id}`, {
    method: "DELETE",
    ...(key !== undefined && { headers: { Authorization: `Bearer ${key}` } }),
  });
}

async function problemOf(answer: Response) {
  expect(answer.headers.get("content-type")).toMatch(/^application\/problem\+json/);
  const problem = problemSchema.parse(await answer.json());
  expect(problem.status).toBe(answer.status);
  return problem;
}

describe("a short link", () => {
  it.each([
    { name: "a maze", document: maze },
    { name: "a program", document: program },
    { name: "a challenge", document: challenge },
    { name: "a lesson of two tasks", document: lesson },
    { name: "a maze with a program", document: project },
    {
      name: "a maze with special characters in its name",
      document: { ...maze, name: '"\\\0\uD800\u2028' },
    },
  ])("returns $name unchanged", async ({ document }) => {
    const relay = await startTestRelay();
    const answer = await post(relay, document);
    expect(answer.status).toBe(201);
    const link = shortLinkSchema.parse(await answer.json());
    expect(answer.headers.get("location")).toBe(`/api/v1/mazes/${link.id}`);
    expect(answer.headers.get("cache-control")).toBe("no-store");
    expect(link.address).toBe(`${relay.origin}/m/${link.id}`);
    expect(link.deleteKey).toMatch(/^del_[A-Za-z0-9_-]{22}$/);
    const read = await get(relay, link.id);
    expect(read.headers.get("content-type")).toMatch(/^application\/json/);
    expect(read.headers.get("cache-control")).toBe("no-store");
    expect(await read.json()).toEqual(document);
  });

  it("is the same for equal documents in any serialisation", async () => {
    const relay = await startTestRelay();
    const first = await store(relay, maze);
    const turned = Object.fromEntries(Object.entries(maze).toReversed());
    const second = await store(relay, JSON.stringify(turned, null, 4));
    expect(second.id).toBe(first.id);
    expect(second.deleteKey).not.toBe(first.deleteKey);
    expect((await store(relay, { ...maze, name: "Other" })).id).not.toBe(first.id);
  });

  it("works after a restart", async () => {
    const dataDir = testFolder();
    const relay = await startTestRelay({ dataDir });
    const { id } = await store(relay, maze);
    await relay.close();
    expect(await (await get(await startTestRelay({ dataDir }), id)).json()).toEqual(maze);
  });

  it("can be created and read from pages of other sites, without cookies", async () => {
    const relay = await startTestRelay();
    const preflight = await fetch(`${relay.origin}/api/v1/mazes`, { method: "OPTIONS" });
    expect(preflight.status).toBe(204);
    for (const answer of [preflight, await post(relay, maze), await get(relay, "AAAAAAAAAAAA")]) {
      expect(answer.headers.get("access-control-allow-origin")).toBe("*");
      expect(answer.headers.get("access-control-allow-credentials")).toBeNull();
      expect(answer.headers.get("x-content-type-options")).toBe("nosniff");
    }
  });

  it("is deleted with its key, and nothing remains in the files", async () => {
    const dataDir = testFolder();
    const relay = await startTestRelay({ dataDir });
    const onDisk = (): string =>
      readdirSync(dataDir)
        .map((file) => readFileSync(join(dataDir, file), "latin1"))
        .join("");
    const { id, deleteKey } = await store(relay, { ...maze, name: "A maze that is to go" });
    expect(onDisk()).toContain("A maze that is to go");
    expect(onDisk()).not.toContain(deleteKey);
    const robot = await relay.register();
    for (const key of [undefined, "", "del_AAAAAAAAAAAAAAAAAAAAAA", robot.ownerKey]) {
      const refused = await remove(relay, id, key);
      expect(await problemOf(refused)).toMatchObject({ type: "/problems/not-authorised" });
      expect(refused.headers.get("www-authenticate")).toBe("Bearer");
    }
    expect((await remove(relay, id, deleteKey)).status).toBe(204);
    expect(await problemOf(await get(relay, id))).toMatchObject({ type: "/problems/no-document" });
    expect((await remove(relay, id, deleteKey)).status).toBe(404);
    expect(onDisk()).not.toContain("A maze that is to go");
    expect(onDisk()).not.toContain(id);
  });

  it("remains for others who stored the same document", async () => {
    const relay = await startTestRelay();
    const [mine, theirs] = [await store(relay, maze), await store(relay, maze)];
    expect((await remove(relay, mine.id, mine.deleteKey)).status).toBe(204);
    expect((await get(relay, theirs.id)).status).toBe(200);
    expect((await remove(relay, theirs.id, theirs.deleteKey)).status).toBe(204);
    expect((await get(relay, theirs.id)).status).toBe(404);
  });

  it("is limited per network, and the error contains the time to wait", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    for (let n = 0; n < 80; n++) await store(relay, maze);
    const refused = await post(relay, maze);
    expect(refused.headers.get("retry-after")).toBe("30");
    expect(await problemOf(refused)).toMatchObject({ type: "/problems/too-fast" });
    await clock.pass(30_000);
    await store(relay, maze);
  });
});

describe("a short code", () => {
  it("has 4 letters and is case-insensitive", async () => {
    const relay = await startTestRelay();
    const { id, address } = await store(relay, maze);
    expect(id).toMatch(/^[BCDFGHJKLMNPQRSTVWXZ]{4}$/);
    expect(address).toBe(`${relay.origin}/m/${id}`);
    expect(await (await get(relay, id.toLowerCase())).json()).toEqual(maze);
  });

  it("can be guessed at most five times a second, while a right code waits its turn", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const { id } = await store(relay, maze);
    const wrong = id === "BBBB" ? "CCCC" : "BBBB";
    expect((await get(relay, wrong)).status).toBe(404);
    const answers: number[] = [];
    for (const each of [wrong, id])
      void get(relay, each).then(({ status }) => answers.push(status));
    await clock.pass(0);
    expect(answers).toEqual([]);
    await vi.waitFor(async () => {
      await clock.pass(200);
      expect(answers).toHaveLength(2);
    });
    expect(new Set(answers)).toEqual(new Set([200, 404]));
  });

  it("can be read any number of times", async () => {
    const relay = await startTestRelay();
    const { id } = await store(relay, maze);
    for (let n = 0; n < 150; n++) expect((await get(relay, id)).status).toBe(200);
  });
});

describe("an invalid document", () => {
  it.each(badDocuments)("is rejected with the name of its field: $name", async ({ body, path }) => {
    const relay = await startTestRelay();
    const problem = await problemOf(await post(relay, body));
    expect(problem).toMatchObject({ status: 400, type: "/problems/bad-request" });
    expect(problem.errors[0]?.path).toBe(path);
    expect(problem.errors[0]?.found).not.toBe("");
    expect(problem.errors[0]?.expected).toMatch(/\w/);
    expect(problem.detail).toMatch(/^Invalid document\./);
  });

  it.each([
    { name: "text/plain", headers: { "Content-Type": "text/plain" } },
    { name: "compressed", headers: { "Content-Encoding": "gzip" } },
  ])("is rejected with 415: $name", async ({ headers }) => {
    const relay = await startTestRelay();
    expect((await problemOf(await post(relay, maze, headers))).status).toBe(415);
  });

  it("is rejected above the size limit and accepted at the limit", async () => {
    const relay = await startTestRelay();
    const text = JSON.stringify(maze);
    await store(relay, " ".repeat(MAX_DOCUMENT_BYTES - text.length) + text);
    const problem = await problemOf(await post(relay, " ".repeat(MAX_DOCUMENT_BYTES) + text));
    expect(problem).toMatchObject({ status: 413, detail: expect.stringContaining("64 KiB") });
  });

  it("does not raise the lower limit of robots", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const body = " ".repeat(17 * 1024);
    const problem = await problemOf(await relay.ask(robot, "/commands", { method: "POST", body }));
    expect(problem).toMatchObject({ status: 413, detail: expect.stringContaining("16 KiB") });
  });
});

describe("an unknown link", () => {
  it.each(["AAAAAAAAAAAA", "__proto__", "a%00b", "x".repeat(500), "'; DROP TABLE documents; --"])(
    "says so: %s",
    async (id) => {
      const relay = await startTestRelay();
      expect(await problemOf(await get(relay, encodeURI(id)))).toMatchObject({
        type: "/problems/no-document",
      });
    },
  );

  it("lists the supported methods", async () => {
    const { origin } = await startTestRelay();
    const listing = await fetch(`${origin}/api/v1/mazes`);
    expect(listing.status).toBe(405);
    expect(listing.headers.get("allow")).toBe("POST");
    const put = await fetch(`${origin}/api/v1/mazes/AAAAAAAAAAAA`, { method: "PUT" });
    expect(put.headers.get("allow")).toBe("GET, DELETE");
  });
});
