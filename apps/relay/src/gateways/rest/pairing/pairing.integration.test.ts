import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { keyListSchema, PAIRING_LETTERS } from "@corridor/protocol";
import { pino } from "pino";
import { describe, expect, it, vi } from "vitest";
import { hashKey } from "../../../platform/keys.ts";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { ownerOf, scriptAt } from "../../../testing/pairing-parties.ts";
import { startTestRelay, testFolder } from "../../../testing/test-relay.ts";

const MINUTE = 60_000;

async function withRobot(options: Parameters<typeof startTestRelay>[0] = {}) {
  const relay = await startTestRelay(options);
  const robot = await relay.register();
  return { relay, robot, owner: ownerOf(relay, robot), script: scriptAt(relay) };
}

/** Status of a script's request to the address from the pairing. */
async function drive(address: string): Promise<number> {
  const { origin, pathname, hash } = new URL(address);
  const answer = await fetch(`${origin}/api/v1/robots/${pathname.slice(3)}/commands`, {
    method: "POST",
    headers: { Authorization: `Bearer ${hash.slice(1)}`, "Content-Type": "application/json" },
    body: JSON.stringify({ action: "left 90" }),
  });
  return answer.status;
}

const wrongCode = (at: number): string =>
  Array.from({ length: 8 }, (_, place) =>
    PAIRING_LETTERS.charAt(Math.floor(at / 20 ** place) % 20),
  ).join("");

describe("pairing with a code", () => {
  it("returns the robot's address with a new key once the owner accepts", async () => {
    const { relay, robot, owner, script } = await withRobot();
    const code = await owner.code();
    expect(code).toMatch(/^[BCDFGHJKLMNPQRSTVWXZ]{8}$/);
    expect(await owner.show()).toMatchObject({ state: "open", question: null });
    const waiting = owner.show(25);
    // As a person types it.
    const typed = ` ${code.slice(0, 4).toLowerCase()}-${code.slice(4)} `;
    const asked = await script.ask(
      { code: typed, name: "Right\nwall" },
      { "User-Agent": "curl/8" },
    );
    expect(asked).toMatchObject({ status: 202 });
    const key = asked.body?.key ?? "";
    expect(await waiting).toMatchObject({
      state: "asked",
      question: { id: hashKey(key).slice(0, 6), name: "Right wall", client: "curl" },
    });
    expect((await script.receive(key)).body).toMatchObject({ state: "asked", address: null });
    const answer = script.receive(key, 25);
    expect(await owner.say(true)).toBe("");
    const { body } = await answer;
    expect(body).toMatchObject({ state: "accepted" });
    expect(body?.address).toBe(`${relay.origin}/r/${robot.id}#${key}`);
    expect(await drive(body?.address ?? "")).toBe(202);
    // The response can be requested again if it was lost.
    const repeated = { ...body, endsInSeconds: expect.any(Number) };
    expect((await script.receive(key)).body).toEqual(repeated);

    const own = { key: robot.ownerKey };
    const { keys } = keyListSchema.parse(await (await relay.ask(robot, "/keys", own)).json());
    const { id = "" } = keys.find((each) => each.id === hashKey(key).slice(0, 6)) ?? {};
    await relay.ask(robot, `/keys/${id}`, { method: "DELETE", ...own });
    expect(await drive(body?.address ?? "")).toBe(401);
  });

  it("returns nothing if the owner declines", async () => {
    const { owner, script, relay, robot } = await withRobot();
    const key = (await script.ask({ code: await owner.code() })).body?.key ?? "";
    const answer = script.receive(key, 25);
    expect(await owner.say(false)).toBe("");
    expect(await answer).toMatchObject({ status: 403, kind: "pairing-refused" });
    expect(await drive(`${relay.origin}/r/${robot.id}#${key}`)).toBe(401);
    expect(await owner.say(true)).toBe("no-question");
  });

  it("accepts the same answer again, and activates no key that was revoked since", async () => {
    const { owner, script, relay, robot } = await withRobot();
    const key = (await script.ask({ code: await owner.code() })).body?.key ?? "";
    expect(await owner.say(true)).toBe("");
    expect(await owner.say(true)).toBe("");
    expect(await owner.say(false)).toBe("no-question");
    const own = { method: "DELETE", key: robot.ownerKey };
    await relay.ask(robot, `/keys/${hashKey(key).slice(0, 6)}`, own);
    expect(await owner.say(true)).toBe("");
    expect(await drive(`${relay.origin}/r/${robot.id}#${key}`)).toBe(401);
  });

  it("works for one script, and only with the newest code", async () => {
    const { owner, script } = await withRobot();
    const first = await owner.code();
    const second = await owner.code();
    expect(await script.ask({ code: first })).toMatchObject({ status: 404, kind: "no-pairing" });
    const asked = await Promise.all([1, 2, 3].map(() => script.ask({ code: second })));
    expect(asked.filter(({ status }) => status === 202)).toHaveLength(1);
    expect(asked.filter(({ kind }) => kind === "code-used")).toHaveLength(2);
    expect(await owner.withdraw()).toBe(204);
    const key = asked.find(({ body }) => body !== null)?.body?.key ?? "";
    expect(await script.receive(key, 25)).toMatchObject({ status: 404, kind: "no-pairing" });
    expect(await owner.show()).toMatchObject({ state: "none" });
  });

  it("explains what to send if the code has an invalid format", async () => {
    const { script } = await withRobot();
    for (const code of ["", "BCDFGHJ", "BCDFGHJA", "BCDFGHJKL", "BCDF_GHJK", 7, null]) {
      expect((await script.ask({ code })).status).toBe(400);
    }
    const unknown = await script.ask({ code: "BCDFGHJK", key: "x" });
    expect(unknown).toMatchObject({ status: 400, kind: "bad-request" });
    expect((await script.receive("drv_AAAAAAAAAAAAAAAAAAAAAA")).kind).toBe("no-pairing");
  });

  it("accepts the longest name with escaped characters, as Python sends it", async () => {
    const { relay, owner } = await withRobot();
    const body = { code: await owner.code(), name: "\u0416".repeat(200) };
    const answer = await fetch(`${relay.origin}/api/v1/pairing`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body).replaceAll("\u0416", String.raw`\u0416`),
    });
    expect(answer.status).toBe(202);
    expect(await owner.show()).toMatchObject({ question: { name: "\u0416".repeat(40) } });
  });

  it("lets the owner accept again after revoking a key", async () => {
    const { relay, robot, owner, script } = await withRobot();
    const own = { key: robot.ownerKey };
    const watch = { method: "POST", body: { kind: "watch" }, ...own };
    const made = await relay.ask(robot, "/keys", watch);
    for (let count = 3; count < 12; count++) await relay.ask(robot, "/keys", watch);
    const key = (await script.ask({ code: await owner.code() })).body?.key ?? "";
    expect(await owner.say(true)).toBe("too-many-keys");
    expect((await script.receive(key)).body).toMatchObject({ state: "asked" });
    const { id } = (await made.json()) as { id: string };
    await relay.ask(robot, `/keys/${id}`, { method: "DELETE", ...own });
    expect(await owner.say(true)).toBe("");
    expect((await script.receive(key)).body).toMatchObject({ state: "accepted" });
  });

  it("ends after 10 minutes and leaves nothing in the files", async () => {
    const clock = new FakeClock();
    const dataDir = testFolder();
    const { owner, script } = await withRobot({ clock, dataDir });
    const holds = (text: string) =>
      readdirSync(dataDir).some((file) => readFileSync(join(dataDir, file)).includes(text));
    const code = await owner.code();
    const key = (await script.ask({ code, name: "A forgettable name" })).body?.key ?? "";
    expect(holds(hashKey(code))).toBe(true);
    for (const secret of [code, key]) expect(holds(secret)).toBe(false);
    await clock.pass(10 * MINUTE - 1_000);
    expect((await script.receive(key)).body).toMatchObject({ state: "asked", endsInSeconds: 1 });
    await clock.pass(1_000);
    expect(await owner.say(true)).toBe("no-question");
    expect((await script.receive(key)).kind).toBe("no-pairing");
    await clock.pass(MINUTE);
    for (const text of [hashKey(code), hashKey(key), "A forgettable name"]) {
      expect(holds(text)).toBe(false);
    }
  });

  it("limits the duration and the number of waiting requests", async () => {
    const { owner, script, relay } = await withRobot();
    const key = (await script.ask({ code: await owner.code() })).body?.key ?? "";
    const waiting = Array.from({ length: 6 }, () => script.receive(key, 25));
    const refused = await Promise.race(waiting);
    expect(refused).toMatchObject({ status: 429, kind: "too-many-readers", retryAfter: 2 });
    await relay.close();
    const answers = await Promise.all(waiting);
    expect(answers.filter(({ status }) => status === 200)).toHaveLength(4);
  });

  it("logs neither code nor key", async () => {
    const lines: string[] = [];
    const log = pino({ level: "trace" }, { write: (line: string) => void lines.push(line) });
    const { owner, script } = await withRobot({ log });
    const code = await owner.code();
    await script.ask({ code: "BCDFGHJK" });
    const key = (await script.ask({ code })).body?.key ?? "";
    await owner.say(true);
    await script.receive(key);
    const text = lines.join("");
    expect(text).toContain("/pairing");
    for (const secret of [code, "BCDFGHJK", key.slice(4), hashKey(code), hashKey(key)]) {
      expect(text).not.toContain(secret);
    }
  });
});

/** Requests arrive over real sockets while the test clock advances. */
async function advanceUntil<T>(clock: FakeClock, work: Promise<T>): Promise<T> {
  let isDone = false;
  void work.finally(() => (isDone = true)).catch(() => undefined);
  while (!isDone) {
    await clock.pass(200);
    await new Promise((resolve) => setImmediate(resolve));
  }
  return work;
}

describe("guessing codes", () => {
  const config = { trustedProxies: 1 };
  const from = (address: string) => ({ "X-Forwarded-For": address });

  it("rejects no right code because of wrong ones from the same address", async () => {
    const clock = new FakeClock();
    const { owner, script } = await withRobot({ clock, config });
    const code = await owner.code();
    const guesses = Array.from({ length: 40 }, async (_, count) =>
      script.ask({ code: wrongCode(count) }, from("10.0.0.1")),
    );
    expect(await Promise.race(guesses)).toMatchObject({ status: 404, kind: "no-pairing" });
    const all = Promise.all([script.ask({ code }, from("10.0.0.1")), ...guesses]);
    const [mine] = await advanceUntil(clock, all);
    expect(mine).toMatchObject({ status: 202 });
  });

  it("delays codes of other addresses by 10 ms at most", async () => {
    const clock = new FakeClock();
    const { owner, script } = await withRobot({ clock, config });
    await script.ask({ code: wrongCode(1) }, from("10.0.0.1"));
    const code = await owner.code();
    await clock.pass(10);
    expect((await script.ask({ code }, from("10.0.0.2"))).status).toBe(202);
  });

  it("stops checking codes that are sent all at once, and returns the time to wait", async () => {
    const { relay, script } = await withRobot({ clock: new FakeClock() });
    const asked = Array.from({ length: 90 }, async (_, count) =>
      script.ask({ code: wrongCode(count) }),
    );
    // One check runs and 50 wait.
    const answers: { kind: string; status: number; retryAfter: number }[] = [];
    for (const each of asked) void each.then((answer) => answers.push(answer));
    await vi.waitFor(() => expect(answers).toHaveLength(40), 5_000);
    expect(answers.filter(({ kind }) => kind === "no-pairing")).toHaveLength(1);
    const late = answers.filter(({ kind }) => kind === "too-fast");
    expect(late).toHaveLength(39);
    expect(late.every(({ status, retryAfter }) => status === 429 && retryAfter === 1)).toBe(true);
    await relay.close();
    await Promise.allSettled(asked);
  });

  it("does not delay a class that types right codes", async () => {
    const { owner, script } = await withRobot();
    for (let count = 0; count < 120; count++) {
      expect((await script.ask({ code: await owner.code() })).status).toBe(202);
    }
  });
});
