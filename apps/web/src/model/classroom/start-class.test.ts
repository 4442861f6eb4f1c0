import { describe, expect, it } from "vitest";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { namesOf, startClass } from "./start-class.ts";

const created = {
  id: "A".repeat(22),
  code: "BCDFGH",
  teacherKey: `tea_${"B".repeat(22)}`,
  screenKey: `scr_${"C".repeat(22)}`,
  address: "http://localhost/class/x",
  endsInSeconds: 43_200,
};
const request = { lesson: sampleLesson, names: null, expected: 24 };

function json(status: number, body: unknown): Response {
  const headers = { "Content-Type": "application/json" };
  return new Response(JSON.stringify(body), { status, headers });
}

describe("starting a class", () => {
  it("sends the lesson, the names and the number of students, and nothing else", async () => {
    const sent: unknown[] = [];
    const result = await startClass(request, (_url, { body }) => {
      sent.push(JSON.parse(body));
      return Promise.resolve(json(201, created));
    });
    expect(result).toEqual({ ok: true, value: created });
    expect(sent).toMatchObject([{ names: null, expected: 24, lesson: { name: "Sensors" } }]);
    expect(Object.keys(sent[0] as object)).toEqual(["names", "expected", "lesson"]);
  });

  it.each([
    {
      what: "a web page of a static host",
      answer: new Response("<!doctype html>", { status: 404 }),
      problem: "offline",
    },
    { what: "a relay that fails", answer: json(503, {}), problem: "offline" },
    { what: "a relay that does not know the lesson", answer: json(422, {}), problem: "old" },
    { what: "too many classes", answer: json(429, {}), problem: "too-many" },
  ])("explains $what", async ({ answer, problem }) => {
    expect(await startClass(request, () => Promise.resolve(answer))).toEqual({
      ok: false,
      problem,
    });
  });

  it("refuses a lesson that is too large without a request", async () => {
    const lesson = { ...sampleLesson, intro: "x".repeat(70_000) };
    const result = await startClass({ ...request, lesson }, () =>
      Promise.reject(new Error("sent")),
    );
    expect(result).toEqual({ ok: false, problem: "too-large" });
  });
});

describe("pasted names", () => {
  it("are one a line", () => {
    expect(namesOf(" Team 1\r\n\nTeam 2 \n")).toEqual(["Team 1", "Team 2"]);
  });

  it.each(["", "Team 1\nTeam 1", "x".repeat(25)])("%j is refused", (text) => {
    expect(namesOf(text)).toBeNull();
  });
});
