/** A code in place of an address: by itself, and at the real relay. */
import { describe, expect, it, onTestFinished } from "vitest";
import { pairRobot } from "./pairing.ts";
import type { HttpRequest } from "./platform.ts";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { robotWithCode } from "./testing/robot-with-code.ts";

const ADDRESS = `https://host/r/${"A".repeat(22)}#drv_AAAAAAAAAAAAAAAAAAAAAA`;
const answer = (status: number, body: unknown) => ({ status, body: JSON.stringify(body) });
const asked = answer(202, { key: "drv_new", endsInSeconds: 60 });
const said = (address: string | null) =>
  answer(200, { state: address === null ? "asked" : "accepted", address, endsInSeconds: 9 });
const problem = (status: number, kind: string) =>
  answer(status, { type: `/problems/${kind}`, title: "No", status, detail: "So.", errors: [] });

/** A platform whose service gives these answers, the last again and again, each after 20 s. */
function withAnswers(...answers: ({ status: number; body: string } | null)[]) {
  const platform = new FakePlatform();
  const requests: HttpRequest[] = [];
  const ask = (request: HttpRequest) => {
    requests.push(request);
    platform.pass(19_000);
    const next = answers.length > 1 ? answers.shift() : answers[0];
    const got = next ? Promise.resolve(next) : Promise.reject(new TypeError("offline"));
    // The pauses between tries go by themselves.
    setTimeout(() => platform.pass(10_000));
    return { answer: got, cancel: () => undefined };
  };
  const tries = { wrong: 0 };
  const pair = (code = "bcdf-ghjk", service = "https://host/some/page") => {
    const { clock, random, connect, uniqueText } = platform;
    const on = { clock, random, connect, uniqueText, ask };
    return pairRobot(on, { service, code, name: "Me" }, 30_000, tries);
  };
  return { requests, pair };
}

describe("pairing by a code", () => {
  it("asks with the code, and waits for the owner's yes", async () => {
    const { requests, pair } = withAnswers(asked, said(null), null, said(ADDRESS));
    expect(await pair()).toBe(ADDRESS);
    const [asking, waiting] = requests;
    expect(asking).toMatchObject({ method: "POST", url: "https://host/api/v1/pairing" });
    expect(JSON.parse(asking?.body ?? "")).toEqual({ code: "BCDFGHJK", name: "Me" });
    expect(waiting).toMatchObject({ url: "https://host/api/v1/pairing?wait=10", key: "drv_new" });
  });

  it.each([
    { code: "wrong-code", answers: [problem(404, "no-pairing")] },
    { code: "wrong-code", answers: [problem(409, "code-used")] },
    { code: "too-many-tries", answers: [problem(429, "too-fast")] },
    { code: "pairing-refused", answers: [asked, problem(403, "pairing-refused")] },
    { code: "pairing-over", answers: [asked, problem(404, "no-pairing")] },
    { code: "pairing-over", answers: [asked, said(null)] },
    { code: "bad-address", answers: [{ status: 404, body: "<html>" }] },
    { code: "timeout", answers: [null] },
  ])("fails as $code", async ({ code, answers }) => {
    await expect(withAnswers(...answers).pair()).rejects.toMatchObject({ code });
  });

  it("sends a code again that was not checked beside the wrong ones of others", async () => {
    const { requests, pair } = withAnswers(problem(429, "too-fast"), asked, said(ADDRESS));
    expect(await pair()).toBe(ADDRESS);
    expect(requests.map(({ method }) => method)).toEqual(["POST", "POST", "GET"]);
  });

  it("asks nobody for what is no code, or where there is no service", async () => {
    const { requests, pair } = withAnswers(asked);
    await expect(pair("ABCDEFGH")).rejects.toMatchObject({ code: "wrong-code" });
    await expect(pair("BCDFGHJK", "host")).rejects.toMatchObject({ code: "bad-address" });
    expect(requests).toEqual([]);
  });

  it("lets a page or a program be wrong ten times", async () => {
    const { requests, pair } = withAnswers(problem(404, "no-pairing"));
    for (let count = 0; count < 10; count++) {
      await expect(pair()).rejects.toMatchObject({ code: "wrong-code" });
    }
    await expect(pair()).rejects.toMatchObject({ code: "too-many-tries" });
    expect(requests).toHaveLength(10);
  });
});

describe("at the real relay", () => {
  it("drives after a yes, by a key of its own", async () => {
    const { origin, code, say, registration } = await robotWithCode(["####", "#..#", "####"]);
    const pairing = RobotClient.pair(origin, code, { name: "Paired" });
    await say(true);
    const robot = await pairing;
    onTestFinished(() => robot.close());
    expect(await robot.right90()).toMatchObject({ state: "completed" });
    expect(robot.address).toContain(`${origin}/r/${registration.id}#drv_`);
    expect(robot.address).not.toBe(registration.address);
  });

  it("is told of a no", async () => {
    const { origin, code, say } = await robotWithCode(["####", "#..#", "####"]);
    const pairing = RobotClient.pair(origin, code);
    await Promise.all([
      expect(pairing).rejects.toMatchObject({ code: "pairing-refused" }),
      say(false),
    ]);
  });
});
