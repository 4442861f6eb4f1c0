import { describe, expect, it } from "vitest";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { ClassCalls } from "./class-calls.ts";

const room = { id: "A".repeat(22), key: `tea_${"B".repeat(22)}` };

function callsTo(answer: () => Response) {
  const sent: string[] = [];
  const calls = new ClassCalls(room, (url, { method, headers, body }) => {
    const { Authorization } = headers as Record<string, string>;
    const what = url.replace(`/api/v1/classes/${room.id}`, "");
    expect(Authorization).toBe(`Bearer ${room.key}`);
    sent.push([method, what, typeof body === "string" ? body.slice(0, 40) : ""].join(" ").trim());
    return Promise.resolve(answer());
  });
  return { calls, sent };
}

const done = () => new Response(null, { status: 204 });

describe("what a teacher sets", () => {
  it("is sent to the class", async () => {
    const { calls, sent } = callsTo(done);
    await calls.pause(300);
    await calls.resume();
    await calls.lock(true);
    await calls.setPace(2);
    await calls.setPace(null);
    await calls.sendLesson(sampleLesson);
    await calls.remove(7);
    await calls.end();
    expect(sent).toEqual([
      'PUT /pause {"seconds":300}',
      "DELETE /pause",
      "PUT /lock",
      'PUT /pace {"to":2}',
      "DELETE /pace",
      expect.stringMatching(/^PUT \/lesson \{"format":"corridor\/challenge"/),
      "DELETE /students/7",
      "DELETE",
    ]);
  });

  it.each([
    { status: 413, refusal: "too-large" },
    { status: 429, refusal: "too-many" },
    { status: 503, refusal: "offline" },
    { status: 422, refusal: "old" },
    { status: 404, refusal: null },
  ])("is refused as $refusal with the status $status", async ({ status, refusal }) => {
    const { calls } = callsTo(() => new Response("{}", { status }));
    expect(await calls.newCode()).toBe(refusal);
  });

  it("reports a lost network", async () => {
    const calls = new ClassCalls(room, () => Promise.reject(new TypeError("no network")));
    expect(await calls.lock(false)).toBe("offline");
    expect(await calls.program(1)).toBeNull();
  });

  it("reads a return code and the program of a student", async () => {
    const code = { code: "BCDFGH", endsInSeconds: 600 };
    expect(await callsTo(() => Response.json(code, { status: 201 })).calls.returnCode(1)).toEqual(
      code,
    );
    const program = { task: 1, link: "1abc", storedAt: "2026-01-01T08:00:00.000Z" };
    expect(await callsTo(() => Response.json(program)).calls.program(1)).toEqual(program);
    expect(await callsTo(() => Response.json({ task: 99 })).calls.program(1)).toBeNull();
  });
});
