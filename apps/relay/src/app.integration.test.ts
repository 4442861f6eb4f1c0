import { shortLinkSchema } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { join } from "node:path";
import { Router, type Express } from "express";
import { pino } from "pino";
import { describe, expect, it, onTestFinished } from "vitest";
import type { oas31 } from "zod-openapi";
import { createApp } from "./app.ts";
import { RequestGuard } from "./platform/http/request-guard.ts";
import { classEndpoint } from "./gateways/conversations/class-endpoint.ts";
import { robotEndpoint } from "./gateways/conversations/endpoint.ts";
import { LongPollConnections } from "./gateways/long-poll/long-poll-connections.ts";
import { Metrics } from "./ops/metrics.ts";
import { Readiness } from "./ops/readiness.ts";
import { systemClock } from "./platform/time/clock.ts";
import { LocalClassBus } from "./bus/local-class-bus.ts";
import { ClassRegistry } from "./classes/registry.ts";
import { SqliteClassStore } from "./store/sqlite/sqlite-class-store.ts";
import { DocumentService } from "./short-links/document-service.ts";
import { PairingService } from "./pairing/pairing-service.ts";
import { RobotRegistry } from "./robots/registry.ts";
import { SqliteDocumentStore } from "./store/sqlite/sqlite-document-store.ts";
import { SqliteFile } from "./store/sqlite/file/sqlite-file.ts";
import { SqlitePairingStore } from "./store/sqlite/sqlite-pairing-store.ts";
import { SqliteRobotStore } from "./store/sqlite/sqlite-robot-store.ts";
import { DescribedRelay, describedCalls, METHODS } from "./testing/described-relay.ts";
import { challenge, maze, program } from "./platform/testing/sample-documents.ts";
import { completed } from "./platform/testing/messages.ts";
import { defaults, startTestRelay, testFolder } from "./testing/test-relay.ts";
import { TestSocket } from "./testing/test-socket.ts";

const ROBOT = "/api/v1/robots/{id}";
const COMMANDS = `${ROBOT}/commands`;
const RECORD = `${COMMANDS}/{seq}`;
const DOCUMENTS = "/api/v1/mazes";
const DOCUMENT = `${DOCUMENTS}/{id}`;
const SENSORS = `${ROBOT}/sensors`;
const EVENTS = `${ROBOT}/events`;
const LINE = `${ROBOT}/long-poll`;
const MESSAGES = `${LINE}/messages`;
const PAIRING = `${ROBOT}/pairing`;
const PAIR = "/api/v1/pairing";
/** Static files, which are not part of the API. */
const FILES = new Set([
  "get /openapi.json",
  "get /asyncapi.json",
  "get /corridor.py",
  "get /corridor.js",
  "get /corridor-cli.mjs",
  "get /grade.mjs",
]);

/** Express's internal representation of a route or a mounted router. */
interface Layer {
  rawPath: string;
  route?: { methods: Record<string, boolean> };
  handle: { stack?: Layer[] };
}

/** Every operation with an Express handler, such as "get /api/v1/robots/{id}". */
function servedCalls(layers: Layer[], prefix = ""): string[] {
  return layers.flatMap(({ rawPath, route, handle }) => {
    const path = prefix + (rawPath === "/" ? "" : rawPath.replaceAll(/:(\w+)/g, "{$1}"));
    if (route === undefined) return servedCalls(handle.stack ?? [], path);
    return METHODS.filter((method) => route.methods[method]).map((method) => `${method} ${path}`);
  });
}

function appWithoutPage(): Express {
  const file = new SqliteFile(join(testFolder(), "corridor.sqlite"));
  const store = new SqliteRobotStore(file);
  const log = pino({ level: "silent" });
  const registry = new RobotRegistry(store, systemClock, log);
  const documents = new DocumentService(new SqliteDocumentStore(file), systemClock, log);
  const classes = new ClassRegistry({
    store: new SqliteClassStore(file),
    bus: new LocalClassBus(),
    clock: systemClock,
    log,
  });
  const pairings = new SqlitePairingStore(file);
  const pairing = new PairingService({ pairings, robots: store, clock: systemClock, log });
  onTestFinished(async () => {
    longPolls.close();
    classLongPolls.close();
    pairing.close();
    await documents.close();
    await registry.close();
    await classes.close();
    await store.close();
  });
  const guard = new RequestGuard(defaults());
  const readiness = new Readiness(store, systemClock, log);
  const metrics = new Metrics();
  const endpoint = robotEndpoint({ registry, metrics, clock: systemClock });
  const longPolls = new LongPollConnections({ endpoint, clock: systemClock, log, metrics });
  const classLongPolls = new LongPollConnections({
    endpoint: classEndpoint({ classes, metrics, clock: systemClock }),
    clock: systemClock,
    log,
    metrics,
  });
  const services = { registry, classes, longPolls, classLongPolls, documents, pairing };
  const parts = { ...services, guard, readiness, metrics, clock: systemClock, log, page: Router() };
  return createApp({ ...parts, isDevelopment: false, gateways: [] });
}

describe("/openapi.json", () => {
  it("can be read from every site and cached for a while", async () => {
    const { origin } = await startTestRelay();
    const answer = await fetch(`${origin}/openapi.json`);
    expect(answer.status).toBe(200);
    expect(answer.headers.get("content-type")).toMatch(/^application\/json/);
    expect(answer.headers.get("access-control-allow-origin")).toBe("*");
    expect(answer.headers.get("cache-control")).toBe("public, max-age=300");
    const wrong = await fetch(`${origin}/openapi.json`, { method: "POST" });
    expect(wrong.status).toBe(405);
    expect(wrong.headers.get("cache-control")).toBe("no-store");
  });

  it("describes every operation of the application, and no other", async () => {
    const { document } = await DescribedRelay.start();
    const { stack } = appWithoutPage().router as unknown as { stack: Layer[] };
    const served = servedCalls(stack).filter(
      (call) => !FILES.has(call) && !/ \/(?:docs|problems|check)/.test(call),
    );
    expect(served.length).toBeGreaterThan(5);
    const described = describedCalls(document).map(({ name }) => name);
    expect(described.toSorted()).toEqual(served.toSorted());
  });

  it("describes only operations that the server implements", async () => {
    const { relay, document } = await DescribedRelay.start();
    const unknown: string[] = [];
    for (const { name, method, path, operation } of describedCalls(document)) {
      const robot = await relay.register();
      const isOwners = (operation.security ?? []).some((scheme) => "ownerKey" in scheme);
      const stop = new AbortController();
      const answer = await fetch(
        relay.origin + path.replace("{id}", robot.id).replace("{seq}", "1"),
        {
          method: method.toUpperCase(),
          headers: { Authorization: `Bearer ${isOwners ? robot.ownerKey : robot.driverKey}` },
          signal: stop.signal,
        },
      );
      const isDescribed = String(answer.status) in (operation.responses ?? {});
      // An event stream has no end.
      const problem = answer.ok ? "" : await answer.text();
      if (!isDescribed || problem.includes("/problems/not-found")) unknown.push(name);
      stop.abort();
    }
    expect(unknown).toEqual([]);
  });
});

describe("responses match the description", () => {
  it("from the registration to the end of a driven robot", async () => {
    const api = await DescribedRelay.start();
    const { socket: page, epoch } = await TestSocket.page(api.relay, api.robot);
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
    expect((await api.call("get", SENSORS, { query: "?wait=25" })).body).toEqual(snapshotOf());

    const headers = { "Idempotency-Key": "a-key-0001" };
    const move = { body: { action: "move", distance: 100 }, headers };
    expect((await api.call("post", COMMANDS, move)).status).toBe(202);
    expect((await api.call("post", COMMANDS, move)).body).toMatchObject({ duplicate: true });
    page.send({ type: "started", epoch, seq: 1 });
    page.send({ type: "ended", epoch, ...completed(1) });
    const record = await api.call("get", RECORD, { seq: 1, query: "?wait=25" });
    expect(record.body).toMatchObject({ state: "completed" });
    const drive = { action: "drive", left: 0.2, right: -0.2, milliseconds: 602 };
    expect((await api.call("post", COMMANDS, { body: drive })).status).toBe(202);
    expect((await api.call("delete", COMMANDS)).status).toBe(202);
    expect((await api.call("get", COMMANDS, { query: "?after=1" })).body).toMatchObject({
      commands: [{ seq: 2 }, { seq: 3, action: "stop" }],
    });

    const key = api.robot.ownerKey;
    const place = `${ROBOT}/maze` as const;
    expect((await api.call("get", place)).status).toBe(404);
    expect((await api.call("put", place, { key, body: maze })).status).toBe(204);
    expect((await api.call("put", place, { key, body: program })).status).toBe(400);
    expect((await api.call("get", place)).body).toEqual(maze);
    const known = (await api.relay.ask(api.robot, "/maze")).headers.get("etag") ?? "";
    const asked = await api.call("get", place, { headers: { "If-None-Match": known } });
    expect(asked).toEqual({ status: 304, body: undefined });
    const keys = `${ROBOT}/keys` as const;
    expect((await api.call("post", keys, { key, body: { kind: "watch" } })).status).toBe(201);
    expect((await api.call("post", keys, { key, body: { kind: "own" } })).status).toBe(400);
    expect((await api.call("get", keys, { key })).body).toHaveProperty("keys.2");
    expect((await api.call("get", ROBOT, { key })).body).toMatchObject({ snapshot: snapshotOf() });
    expect((await api.call("delete", ROBOT, { key })).status).toBe(204);
    expect((await api.call("get", SENSORS)).status).toBe(404);
  });

  it("of a long-poll connection and of events by long polling", async () => {
    const api = await DescribedRelay.start();
    const hello = { type: "hello", version: 1, role: "drive", key: api.robot.driverKey };
    const opened = await api.call("post", LINE, { body: hello });
    const key = (opened.body as { key: string }).key;
    const messages = [{ type: "command", command: { action: "left 90" } }];
    const sent = await api.call("post", MESSAGES, { key, body: { first: 1, messages } });
    expect(sent.body).toEqual({ taken: 1 });
    const other = await api.call("post", LINE, { body: hello });
    const ahead = { key: (other.body as { key: string }).key, body: { first: 2, messages } };
    expect((await api.call("post", MESSAGES, ahead)).body).toEqual({ taken: 0 });
    const fetched = await api.call("get", MESSAGES, { key, query: "?wait=5" });
    expect(fetched.body).toMatchObject({ first: 1, closed: null });
    expect((await api.call("delete", LINE, { key })).status).toBe(204);
    expect((await api.call("get", MESSAGES, { key })).status).toBe(404);
    // The key alone identifies a connection.
    expect((await api.call("get", MESSAGES, { key: "" })).status).toBe(401);
    expect((await api.call("delete", LINE, { key: "" })).status).toBe(401);
    const late = { key: "", body: { first: 1, messages } };
    expect((await api.call("post", MESSAGES, late)).status).toBe(401);
    expect((await api.call("post", LINE, { body: { ...hello, key: "drv_x" } })).status).toBe(401);
    const first = await api.call("get", EVENTS, { query: "?wait=1" });
    const { since } = first.body as { since: string };
    const next = await api.call("get", EVENTS, { query: `?wait=0&since=${since}` });
    expect(next.body).toEqual({ since, gap: null, states: [], snapshot: null });
    const missed = await api.call("get", EVENTS, { query: "?wait=0&since=00000000-9" });
    expect(missed.body).toMatchObject({ gap: { open: [{ seq: 1, state: "accepted" }] } });
  });

  it("from a pairing code to the owner's acceptance", async () => {
    const api = await DescribedRelay.start();
    const key = api.robot.ownerKey;
    expect((await api.call("get", PAIRING, { key })).body).toMatchObject({ state: "none" });
    const made = await api.call("post", PAIRING, { key });
    const { code } = made.body as { code: string };
    const wrong = { code: code === "BCDFGHJK" ? "BCDFGHJL" : "BCDFGHJK" };
    expect((await api.callAt("post", PAIR, { body: wrong })).status).toBe(404);
    expect((await api.callAt("post", PAIR, { body: { code: "A" } })).status).toBe(400);
    const asked = await api.callAt("post", PAIR, { body: { code, name: "Follower" } });
    expect((await api.callAt("post", PAIR, { body: { code } })).status).toBe(409);
    const waiting = (asked.body as { key: string }).key;
    expect((await api.callAt("get", PAIR, { key: waiting })).status).toBe(200);
    expect((await api.callAt("get", PAIR)).status).toBe(401);
    expect((await api.callAt("get", PAIR, { key })).status).toBe(404);
    const shown = await api.call("get", PAIRING, { key });
    const { id } = (shown.body as { question: { id: string } }).question;
    const yes = { key, body: { id, accept: true } };
    expect((await api.call("put", PAIRING, yes)).status).toBe(204);
    expect((await api.call("put", PAIRING, yes)).status).toBe(204);
    const no = { key, body: { id, accept: false } };
    expect((await api.call("put", PAIRING, no)).status).toBe(409);
    expect((await api.callAt("get", PAIR, { key: waiting })).body).toMatchObject({
      state: "accepted",
    });
    expect((await api.call("delete", PAIRING, { key })).status).toBe(204);
  });

  it.each([
    { name: "a maze", document: maze },
    { name: "a program", document: program },
    { name: "a challenge", document: challenge },
  ])("of the short link of $name", async ({ document }) => {
    const api = await DescribedRelay.start();
    const asked = api.document.paths?.[DOCUMENTS]?.post?.requestBody as oas31.RequestBodyObject;
    const schema = api.schemaOf({ description: "", content: asked.content });
    expect(schema.safeParse(document).success).toBe(true);
    expect(schema.safeParse({ ...document, format: "corridor/run" }).success).toBe(false);
    const { status, body } = await api.callAt("post", DOCUMENTS, { body: document });
    expect(status).toBe(201);
    const { id, deleteKey } = shortLinkSchema.parse(body);
    expect((await api.callAt("get", DOCUMENT, { id })).body).toEqual(document);
    expect((await api.callAt("delete", DOCUMENT, { id })).status).toBe(401);
    expect((await api.callAt("delete", DOCUMENT, { id, key: deleteKey })).status).toBe(204);
    expect((await api.callAt("get", DOCUMENT, { id })).status).toBe(404);
    expect((await api.callAt("post", DOCUMENTS, { body: {} })).status).toBe(400);
    expect((await api.callAt("post", DOCUMENTS)).status).toBe(415);
    const tooLarge = { ...program, name: "x".repeat(70_000) };
    expect((await api.callAt("post", DOCUMENTS, { body: tooLarge })).status).toBe(413);
  });

  const post = ["post", COMMANDS] as const;
  it.each([
    { name: "a wrong command", call: post, request: { body: { action: "fly" } }, status: 400 },
    {
      name: "a wrong query",
      call: ["get", SENSORS] as const,
      request: { query: "?wait=26" },
      status: 400,
    },
    {
      name: "no valid key",
      call: ["get", SENSORS] as const,
      request: { key: "drv_x" },
      status: 401,
    },
    {
      name: "the key of a script",
      call: ["delete", ROBOT] as const,
      request: {},
      status: 403,
    },
    {
      name: "no such command",
      call: ["get", RECORD] as const,
      request: { seq: 9 },
      status: 404,
    },
    { name: "no report yet", call: ["get", SENSORS] as const, request: {}, status: 409 },
    {
      name: "a body that is too large",
      call: post,
      request: { body: " ".repeat(17 * 1024) },
      status: 413,
    },
    {
      name: "a body that is not JSON",
      call: post,
      request: { body: "stop", headers: { "Content-Type": "text/plain" } },
      status: 415,
    },
  ])("for an error: $name", async ({ call: [method, path], request, status }) => {
    const api = await DescribedRelay.start();
    expect((await api.call(method, path, request)).status).toBe(status);
  });

  it("for too many commands, with the time to wait", async () => {
    const api = await DescribedRelay.start();
    const request = { body: { action: "left 90" } };
    const answers = Array.from({ length: 80 }, () => api.call("post", COMMANDS, request));
    const statuses = (await Promise.all(answers)).map(({ status }) => status);
    expect(new Set(statuses)).toEqual(new Set([202, 429]));
  });

  it("and invalid ones are detected", async () => {
    const api = await DescribedRelay.start();
    const schema = api.schemaOf(api.answerOf("get", SENSORS, 200));
    const wrong = [{ line: undefined }, { seq: -1 }, { pose: { x: 0, y: 0, heading: 360 } }];
    expect(schema.safeParse(snapshotOf()).success).toBe(true);
    for (const change of wrong) {
      expect(schema.safeParse({ ...snapshotOf(), ...change }).success).toBe(false);
    }
  });
});
