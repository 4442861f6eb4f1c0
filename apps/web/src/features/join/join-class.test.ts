import type { JoinedClass } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ProblemDocument } from "@corridor/protocol";
import { joinClass } from "./join-class.ts";

const joined: JoinedClass = {
  class: "A".repeat(22),
  student: 1,
  name: { word: 7, text: null },
  key: `stu_${"B".repeat(22)}`,
};

function problem(
  status: number,
  kind: string,
  headers: Record<string, string> = {},
  errors: ProblemDocument["errors"] = [],
): Response {
  const body = { type: `/problems/${kind}`, title: "Title", status, detail: "Why", errors };
  return new Response(JSON.stringify(body), { status, headers });
}

async function joinWith(typed: string, answer: Response) {
  const sent: string[] = [];
  const result = await joinClass(typed, (_url, { body }) => {
    sent.push(body);
    return Promise.resolve(answer);
  });
  return { result, sent };
}

describe("joining a class", () => {
  it.each(["BCDFGH", "bcd fgh", "BCD-FGH"])("accepts %j as typed", async (typed) => {
    const { result, sent } = await joinWith(
      typed,
      new Response(JSON.stringify(joined), { status: 201 }),
    );
    expect(result).toEqual({ ok: true, value: joined });
    expect(sent).toEqual(['{"code":"BCDFGH"}']);
  });

  it.each([
    { typed: "", kind: "wrong" },
    { typed: "ABC DEF", kind: "wrong" },
    { typed: "bcdf ghjk", kind: "robot" },
  ])("says without a request that $typed is $kind", async ({ typed, kind }) => {
    const { result, sent } = await joinWith(typed, problem(404, "no-class"));
    expect(result).toEqual({ ok: false, problem: { kind } });
    expect(sent).toEqual([]);
  });

  it.each([
    { answer: problem(404, "no-class"), expected: { kind: "wrong" } },
    { answer: problem(409, "class-locked"), expected: { kind: "locked" } },
    { answer: problem(409, "class-full"), expected: { kind: "full", count: 200 } },
    {
      answer: problem(409, "class-full", {}, [
        { path: "students", found: "24", expected: "fewer than 24" },
      ]),
      expected: { kind: "full", count: 24 },
    },
    {
      answer: problem(429, "too-many-requests", { "Retry-After": "7" }),
      expected: { kind: "tooFast", seconds: 7 },
    },
    { answer: problem(429, "too-many-requests"), expected: { kind: "tooFast", seconds: 20 } },
    { answer: problem(503, "busy"), expected: { kind: "offline" } },
    { answer: problem(422, "bad-request"), expected: { kind: "old" } },
    { answer: new Response("<!doctype html>", { status: 404 }), expected: { kind: "offline" } },
    { answer: new Response('{"class":1}', { status: 201 }), expected: { kind: "old" } },
  ])("explains $expected", async ({ answer, expected }) => {
    const { result } = await joinWith("BCDFGH", answer);
    expect(result).toEqual({ ok: false, problem: expected });
  });

  it("says that the page is offline", async () => {
    const result = await joinClass("BCDFGH", () => Promise.reject(new TypeError("no network")));
    expect(result).toEqual({ ok: false, problem: { kind: "offline" } });
  });
});
