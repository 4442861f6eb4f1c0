import { expect, it, vi } from "vitest";
import type { Ask } from "./owner-calls.ts";
import { groupedCode, timeText } from "./pairing-text.ts";
import { RobotPairing } from "./robot-pairing.ts";

const owner = { id: "A".repeat(22), ownerKey: "own_secret" };
const question = { id: "k3J9x2", name: "Right wall", client: "Python" };
const made = { code: "BCDFGHJK", endsInSeconds: 600 };
const shown = (state: string, asks: unknown = null) =>
  Response.json({ state, question: asks, endsInSeconds: 500 });

/** The pairing of a page with a service whose responses the test gives one by one. */
function withService() {
  const asked: string[] = [];
  const waiting: ((answer: Response | Error) => void)[] = [];
  const timers: { work: () => void; at: number }[] = [];
  let now = 0;
  const ask: Ask = async (url, { method = "GET", body = "" }) => {
    asked.push(`${method} ${url.replace(/.*\/pairing/, "")} ${body}`.trim());
    return new Promise((resolve, reject) => {
      waiting.push((answer) => (answer instanceof Error ? reject(answer) : resolve(answer)));
    });
  };
  const pairing = new RobotPairing({
    owner,
    ask,
    now: () => now,
    later: (work, milliseconds) => timers.push({ work, at: now + milliseconds }),
  });
  return {
    asked,
    pairing,
    view: () => pairing.store.getState().view,
    answer: async (answer: Response | Error) => {
      await vi.waitFor(() => expect(waiting).not.toEqual([]));
      waiting.shift()?.(answer);
      await new Promise((resolve) => setTimeout(resolve));
    },
    pass: async (milliseconds: number) => {
      now += milliseconds;
      for (const timer of timers.splice(0)) {
        if (timer.at <= now) timer.work();
        else timers.push(timer);
      }
      await new Promise((resolve) => setTimeout(resolve));
    },
  };
}

it("shows a code, then the question, and sends the owner's answer to the service", async () => {
  const { asked, pairing, view, answer } = withService();
  void pairing.open();
  await answer(Response.json(made, { status: 201 }));
  expect(view()).toMatchObject({ kind: "open", code: "BCDFGHJK", endsAt: 600_000 });
  await answer(shown("open"));
  await answer(shown("asked", question));
  expect(view()).toMatchObject({ kind: "asked", question });
  void pairing.accept();
  await answer(new Response(null, { status: 204 }));
  expect(view()).toEqual({ kind: "accepted", question, trouble: null });
  expect(asked).toEqual([
    "POST",
    "GET ?wait=20",
    "GET ?wait=20",
    'PUT  {"id":"k3J9x2","accept":true}',
  ]);
});

it("refuses with the button that cancelled the code before", async () => {
  const { asked, pairing, view, answer } = withService();
  void pairing.open();
  await answer(Response.json(made, { status: 201 }));
  void pairing.decline();
  await answer(new Error("the answer of the wait, which nobody heeds"));
  await answer(new Response(null, { status: 204 }));
  expect(view()).toMatchObject({ kind: "none" });
  void pairing.open();
  await answer(Response.json(made, { status: 201 }));
  await answer(shown("asked", question));
  void pairing.decline();
  await answer(new Response(null, { status: 204 }));
  expect(view()).toMatchObject({ kind: "refused" });
  expect(asked.at(-1)).toBe('PUT  {"id":"k3J9x2","accept":false}');
});

it("sends one answer for a double click, and another one after a failure", async () => {
  const { asked, pairing, view, answer } = withService();
  void pairing.resume();
  await answer(shown("asked", question));
  void pairing.accept();
  void pairing.accept();
  void pairing.decline();
  await answer(new TypeError("offline"));
  expect(view()).toMatchObject({ kind: "asked", trouble: "failed" });
  void pairing.accept();
  await answer(new Response(null, { status: 204 }));
  expect(view()).toMatchObject({ kind: "accepted" });
  const accepted = 'PUT  {"id":"k3J9x2","accept":true}';
  expect(asked).toEqual(["GET ?wait=0", accepted, accepted]);
});

it("continues to poll during a network failure, until the code expires", async () => {
  const { pairing, view, answer, pass } = withService();
  void pairing.open();
  await answer(Response.json(made, { status: 201 }));
  await answer(new TypeError("offline"));
  expect(view()).toMatchObject({ kind: "open" });
  await pass(2_000);
  await pass(600_000);
  await answer(shown("none"));
  expect(view()).toMatchObject({ kind: "over" });
});

it("shows the question again after a reload, and removes it when it expires", async () => {
  const { pairing, view, answer, pass } = withService();
  void pairing.resume();
  await answer(shown("asked", question));
  expect(view()).toMatchObject({ kind: "asked", question });
  void pairing.accept();
  await answer(conflict("too-many-keys"));
  expect(view()).toMatchObject({ kind: "asked", trouble: "tooManyKeys" });
  await pass(500_000);
  expect(view()).toMatchObject({ kind: "over" });
});

it("still waits after a reload for the script that has the earlier code", async () => {
  const { asked, pairing, view, answer } = withService();
  void pairing.resume();
  await answer(shown("open"));
  expect(view()).toMatchObject({ kind: "none" });
  await answer(shown("asked", question));
  expect(view()).toMatchObject({ kind: "asked", question });
  expect(asked).toEqual(["GET ?wait=0", "GET ?wait=20"]);
});

it("shows the code that is being created, even if another part of the page appears meanwhile", async () => {
  const { asked, pairing, view, answer } = withService();
  void pairing.open();
  void pairing.resume();
  await answer(Response.json(made, { status: 201 }));
  expect(view()).toMatchObject({ kind: "open", code: "BCDFGHJK" });
  expect(asked).toEqual(["POST", "GET ?wait=20"]);
});

it("reports that there is no code, or that the request has ended", async () => {
  const { pairing, view, answer } = withService();
  void pairing.open();
  await answer(new TypeError("offline"));
  expect(view()).toEqual({ kind: "none", trouble: "failed" });
  void pairing.resume();
  await answer(shown("asked", question));
  void pairing.accept();
  await answer(conflict("no-question"));
  expect(view()).toMatchObject({ kind: "over" });
});

it("is read in groups, with minutes and seconds", () => {
  expect(groupedCode("BCDFGHJK")).toBe("BCDF GHJK");
  expect([600, 599.2, 65, 0.4, -1].map(timeText)).toEqual([
    "10:00",
    "10:00",
    "1:05",
    "0:01",
    "0:00",
  ]);
});

function conflict(kind: string): Response {
  const words = { title: "It is in the way", detail: "Something else is there.", errors: [] };
  return Response.json({ type: `/problems/${kind}`, status: 409, ...words }, { status: 409 });
}
