import { connect } from "node:net";
import { once } from "node:events";
import { problemSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { badCommands } from "../../testing/bad-commands.ts";
import { startTestRelay } from "../../testing/test-relay.ts";

const HOUR_MS = 60 * 60 * 1000;

/** Parses the problem document of a response. */
async function problemOf(answer: Response) {
  expect(answer.headers.get("content-type")).toMatch(/^application\/problem\+json/);
  const text = await answer.text();
  expect(text).not.toMatch(/node_modules|\.ts:\d|\/src\//);
  const problem = problemSchema.parse(JSON.parse(text));
  expect(problem.status).toBe(answer.status);
  return problem;
}

function isJson(text: string): boolean {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

describe("an invalid command", () => {
  it("that is not JSON is answered with an example", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const answer = await relay.ask(robot, "/commands", { method: "POST", body: "'left 90'" });
    expect((await problemOf(answer)).errors).toEqual([
      {
        path: "",
        found: "text that is not JSON",
        expected: 'a JSON document, such as {"action":"left 90"}',
      },
    ]);
  });

  const quotes = "Put names and texts into double quotes";
  const marks = "Check quotes, commas, brackets and numbers";
  it.each([
    { name: "single quotes", body: "{'action':'left 90'}", says: quotes },
    { name: "one text in single quotes", body: `{"action":'left 90'}`, says: quotes },
    { name: "curly quotes", body: "{“action”:“left 90”}", says: quotes },
    { name: "a name without quotes", body: '{action:"left 90"}', says: quotes },
    { name: "a text without quotes", body: '{"action":stop}', says: quotes },
    { name: "a comma at the end", body: '{"action":"left 90",}', says: marks },
    { name: "NaN", body: '{"action":"move","distance":NaN}', says: marks },
    { name: "no closing bracket", body: '{"action":"move","distance":12', says: marks },
    { name: "a quote that is not closed", body: '{"action":"left 90}', says: marks },
    { name: "a backslash at the end", body: '{"action":"left\\', says: marks },
    { name: "nothing", body: " ", says: "It is empty: send a JSON document" },
  ])("that is not JSON names what to correct: $name", async ({ body, says }) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const answer = await relay.ask(robot, "/commands", { method: "POST", body });
    expect((await problemOf(answer)).detail).toBe(
      `Invalid command. The body is not JSON. ${says}, as in the example in 'errors'.`,
    );
  });

  it.each(badCommands)("is rejected with the name of its field: $name", async ({ body, path }) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const answer = await relay.ask(robot, "/commands", { method: "POST", body });
    const problem = await problemOf(answer);
    expect(problem).toMatchObject({ status: 400, type: "/problems/bad-request" });
    expect(problem.errors[0]?.path).toBe(path);
    // Scripts may print only `detail`, or read it without a JSON parser.
    expect(problem.detail).toMatch(
      isJson(body)
        ? `Invalid command. ${path || "document"}: found `
        : /^Invalid command\. The body is not JSON\. (?:Put|Check|It is empty: send) .*, as in the example/,
    );
    expect(problem.detail).not.toContain('"');
    const log = await relay.ask(robot, "/commands");
    expect(await log.json()).toEqual({ commands: [] });
  });
});

it("an id with a typing error is answered with advice to check it", async () => {
  const relay = await startTestRelay();
  const robot = await relay.register();
  const [first = ""] = robot.id;
  const id = (first === "A" ? "B" : "A") + robot.id.slice(1);
  const problem = await problemOf(await relay.ask({ ...robot, id }, "/sensors"));
  expect(problem).toMatchObject({ status: 404, type: "/problems/no-robot" });
  expect(problem.detail).toBe(
    `Check the id for typing errors, or copy the address again from the robot's page. The relay deletes robots after ${limits.robotIdleMs / HOUR_MS} hours without use, and ${limits.robotLifeMs / HOUR_MS} hours after their registration.`,
  );
});

describe("a key", () => {
  it.each([
    { what: "missing", sent: "", says: "Authorization: Bearer KEY" },
    { what: "not put in", sent: "Bearer KEY", says: "press 'Copy address with key'" },
    {
      what: "replaced by a new one",
      sent: "Bearer drv_AAAAAAAAAAAAAAAAAAAAAA",
      says: "press 'Copy address with key'",
    },
  ])("that is $what is rejected with advice", async ({ sent, says }) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const headers = { Authorization: sent };
    const problem = await problemOf(await relay.ask(robot, "/sensors", { headers }));
    expect(problem).toMatchObject({ status: 401, type: "/problems/not-authorised" });
    expect(problem.detail).toContain(says);
  });
});

describe("an invalid request", () => {
  const json = { "Content-Type": "application/json" };
  const stop = '{"action":"stop"}';
  it.each([
    {
      name: "a body with another content type",
      path: "/commands",
      request: { method: "POST", body: stop, headers: { "Content-Type": "text/plain" } },
      status: 415,
    },
    {
      name: "form data",
      path: "/commands",
      request: {
        method: "POST",
        body: "action=stop",
        headers: { "Content-Type": "application/x-www-form-urlencoded" },
      },
      status: 415,
    },
    {
      name: "a compressed body",
      path: "/commands",
      request: { method: "POST", body: stop, headers: { ...json, "Content-Encoding": "gzip" } },
      status: 415,
    },
    {
      name: "an unknown charset",
      path: "/commands",
      request: {
        method: "POST",
        body: stop,
        headers: { "Content-Type": "application/json; charset=klingon" },
      },
      status: 415,
    },
    {
      name: "a body of more than 16 KiB",
      path: "/commands",
      request: { method: "POST", body: " ".repeat(16 * 1024) + stop },
      status: 413,
    },
    {
      name: "a short idempotency key",
      path: "/commands",
      request: { method: "POST", body: stop, headers: { "Idempotency-Key": "short" } },
      status: 400,
    },
    {
      name: "an idempotency key with spaces",
      path: "/commands",
      request: { method: "POST", body: stop, headers: { "Idempotency-Key": "has some spaces" } },
      status: 400,
    },
    { name: "a wait that is not a number", path: "/sensors?wait=long", request: {}, status: 400 },
    { name: "a wait that is too long", path: "/sensors?wait=26", request: {}, status: 400 },
    { name: "a negative wait", path: "/commands/1?wait=-1", request: {}, status: 400 },
    { name: "two waits", path: "/sensors?wait=1&wait=2", request: {}, status: 400 },
    {
      name: "an after that is not a number",
      path: "/commands?after=first",
      request: {},
      status: 400,
    },
    {
      name: "an after that is not an integer",
      path: "/sensors?after=1.5",
      request: {},
      status: 400,
    },
    {
      name: "an invalid Last-Event-ID with a valid since",
      path: "/events?wait=0&since=AAAAAAAA-1",
      request: { headers: { "Last-Event-ID": "first" } },
      status: 400,
    },
    { name: "a command that does not exist", path: "/commands/99", request: {}, status: 404 },
    { name: "a command that is not a number", path: "/commands/first", request: {}, status: 400 },
    { name: "an address that does not exist", path: "/legs", request: {}, status: 404 },
    {
      name: "a method that does not exist here",
      path: "/sensors",
      request: { method: "PUT" },
      status: 405,
    },
    { name: "PATCH on the commands", path: "/commands", request: { method: "PATCH" }, status: 405 },
    { name: "a malformed address", path: "/commands/%E0%A4%A", request: {}, status: 400 },
    {
      name: "an unknown key",
      path: "/sensors",
      request: { key: "drv_AAAAAAAAAAAAAAAAAAAAAA" },
      status: 401,
    },
    {
      name: "without a bearer key",
      path: "/sensors",
      request: { headers: { Authorization: "Basic abc" } },
      status: 401,
    },
    {
      name: "an empty key",
      path: "/sensors",
      request: { headers: { Authorization: "Bearer " } },
      status: 401,
    },
  ])("is explained in the response: $name", async ({ path, request, status }) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const problem = await problemOf(await relay.ask(robot, path, request));
    expect(problem.status).toBe(status);
    expect(problem.detail).toMatch(/\w+ \w+/);
    const health = await fetch(`${relay.origin}/healthz`);
    expect(await health.json()).toEqual({ status: "ok" });
  });

  it("with the key of another robot is rejected", async () => {
    const relay = await startTestRelay();
    const [robot, other] = [await relay.register(), await relay.register()];
    const answer = await relay.ask(robot, "/commands", {
      method: "POST",
      key: other.driverKey,
      body: { action: "stop" },
    });
    expect((await problemOf(answer)).status).toBe(401);
  });

  it("with a key of another kind is forbidden", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const asOwner = await relay.ask(robot, "/sensors", { key: robot.ownerKey });
    expect((await problemOf(asOwner)).status).toBe(403);
    const asDriver = await relay.ask(robot, "", { method: "DELETE" });
    expect((await problemOf(asDriver)).status).toBe(403);
  });

  it("for an unknown robot requires a key first", async () => {
    const relay = await startTestRelay();
    const { driverKey } = await relay.register();
    const kindFor = async (id: string, headers: HeadersInit): Promise<string> =>
      (await problemOf(await fetch(`${relay.origin}/api/v1/robots/${id}/sensors`, { headers })))
        .type;
    for (const id of ["AAAAAAAAAAAAAAAAAAAAAA", "__proto__", "x".repeat(500)]) {
      expect(await kindFor(id, {})).toBe("/problems/not-authorised");
      // Truncated while copying.
      const cut = { Authorization: `Bearer ${driverKey.slice(0, -1)}` };
      expect(await kindFor(id, cut)).toBe("/problems/not-authorised");
      const whole = { Authorization: `Bearer ${driverKey}` };
      expect(await kindFor(id, whole)).toBe("/problems/no-robot");
    }
  });

  it.each([
    { name: "not HTTP", bytes: "hello robot\r\n\r\n" },
    {
      name: "headers of more than 8 KiB",
      bytes: `GET / HTTP/1.1\r\nHost: a\r\nX: ${"x".repeat(9_000)}\r\n\r\n`,
    },
    {
      name: "an invalid Host",
      bytes: "POST /api/v1/robots HTTP/1.1\r\nHost: a b/c\r\nConnection: close\r\n\r\n",
    },
  ])("on a raw connection is answered with 4xx: $name", async ({ bytes }) => {
    const relay = await startTestRelay();
    const socket = connect(Number(new URL(relay.origin).port), "127.0.0.1");
    // Not `end`: Node.js answers nothing that becomes ready after the client's end of stream.
    socket.write(bytes);
    const [answer] = (await once(socket, "data")) as [Buffer];
    expect(answer.toString()).toMatch(/^HTTP\/1\.1 4\d\d /);
    socket.destroy();
    expect((await fetch(`${relay.origin}/healthz`)).status).toBe(200);
  });
});
