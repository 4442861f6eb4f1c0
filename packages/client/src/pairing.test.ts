/** Pairing with a fake service. */
import { describe, expect, it } from "vitest";
import { pairRobot } from "./pairing.ts";
import type { HttpRequest } from "./platform.ts";
import { FakePlatform } from "./testing/fake-platform.ts";

const ADDRESS = `https://host/r/${"A".repeat(22)}#drv_AAAAAAAAAAAAAAAAAAAAAA`;
const answer = (status: number, body: unknown) => ({ status, body: JSON.stringify(body) });
const requested = answer(202, { key: "drv_new", endsInSeconds: 60 });
const answered = (address: string | null) =>
  answer(200, { state: address === null ? "asked" : "accepted", address, endsInSeconds: 9 });
const problem = (status: number, kind: string) =>
  answer(status, { type: `/problems/${kind}`, title: "No", status, detail: "So.", errors: [] });

/** A platform whose service sends these responses, each after 19 s, and repeats the last one. */
function withAnswers(...answers: ({ status: number; body: string } | null)[]) {
  const platform = new FakePlatform();
  const requests: HttpRequest[] = [];
  const request = (request: HttpRequest) => {
    requests.push(request);
    platform.pass(19_000);
    const next = answers.length > 1 ? answers.shift() : answers[0];
    const response = next ? Promise.resolve(next) : Promise.reject(new TypeError("offline"));
    // Delays between attempts pass automatically.
    setTimeout(() => platform.pass(10_000));
    return { response, cancel: () => undefined };
  };
  const attempts = { wrong: 0 };
  const pair = (code = "bcdf-ghjk", service = "https://host/some/page") => {
    const { clock, random, connect, uniqueText } = platform;
    const on = { clock, random, connect, uniqueText, request };
    return pairRobot(on, { service, code, name: "Me" }, 30_000, attempts);
  };
  return { requests, pair };
}

describe("pairing by a code", () => {
  it("sends the code, and waits until the owner accepts", async () => {
    const { requests, pair } = withAnswers(requested, answered(null), null, answered(ADDRESS));
    expect(await pair()).toBe(ADDRESS);
    const [post, poll] = requests;
    expect(post).toMatchObject({ method: "POST", url: "https://host/api/v1/pairing" });
    expect(JSON.parse(post?.body ?? "")).toEqual({ code: "BCDFGHJK", name: "Me" });
    expect(poll).toMatchObject({ url: "https://host/api/v1/pairing?wait=10", key: "drv_new" });
  });

  it.each([
    { code: "wrong-code", answers: [problem(404, "no-pairing")] },
    { code: "wrong-code", answers: [problem(409, "code-used")] },
    { code: "too-many-tries", answers: [problem(429, "too-fast")] },
    { code: "pairing-refused", answers: [requested, problem(403, "pairing-refused")] },
    { code: "pairing-over", answers: [requested, problem(404, "no-pairing")] },
    { code: "pairing-over", answers: [requested, answered(null)] },
    { code: "bad-address", answers: [{ status: 404, body: "<html>" }] },
    { code: "timeout", answers: [null] },
  ])("fails as $code", async ({ code, answers }) => {
    await expect(withAnswers(...answers).pair()).rejects.toMatchObject({ code });
  });

  it("sends a code again if the service did not check it after too many wrong ones", async () => {
    const { requests, pair } = withAnswers(problem(429, "too-fast"), requested, answered(ADDRESS));
    expect(await pair()).toBe(ADDRESS);
    expect(requests.map(({ method }) => method)).toEqual(["POST", "POST", "GET"]);
  });

  it.each([408, 425, 500])("sends a request again after the status %i", async (status) => {
    const { requests, pair } = withAnswers({ status, body: "" }, requested, answered(ADDRESS));
    expect(await pair()).toBe(ADDRESS);
    expect(requests).toHaveLength(3);
  });

  it("sends no request for an invalid code or address", async () => {
    const { requests, pair } = withAnswers(requested);
    await expect(pair("ABCDEFGH")).rejects.toMatchObject({ code: "wrong-code" });
    await expect(pair("BCDFGHJK", "host")).rejects.toMatchObject({ code: "bad-address" });
    expect(requests).toEqual([]);
  });

  it("permits ten wrong codes per page load or process", async () => {
    const { requests, pair } = withAnswers(problem(404, "no-pairing"));
    for (let count = 0; count < 10; count++) {
      await expect(pair()).rejects.toMatchObject({ code: "wrong-code" });
    }
    await expect(pair()).rejects.toMatchObject({ code: "too-many-tries" });
    expect(requests).toHaveLength(10);
  });
});
