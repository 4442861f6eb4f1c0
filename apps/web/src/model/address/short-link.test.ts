import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { expect, it, vi } from "vitest";
import { threeTasks } from "../challenge/testing/three-tasks.ts";
import { readShortLink } from "./short-link.ts";

const id = "AAAAAAAAAAAA";
const maze = mazePresets[0]?.maze;
const program = programPresets[0]?.program;

const pause = vi.fn<() => Promise<void>>(() => Promise.resolve());

const answers = (status: number, body: unknown) => () =>
  Promise.resolve({
    ok: status === 200,
    status,
    text: () => Promise.resolve(typeof body === "string" ? body : JSON.stringify(body)),
  });

it.each([
  { what: "a maze", document: maze, value: { maze } },
  { what: "a program", document: program, value: { program } },
  { what: "a lesson", document: threeTasks, value: { lesson: threeTasks } },
  {
    what: "a maze with a program",
    document: { format: "corridor/project", version: 1, maze, program },
    value: { maze, program },
  },
])("loads $what", async ({ document, value }) => {
  expect(await readShortLink(id, answers(200, document), pause)).toEqual({ ok: true, value });
});

it("distinguishes deleted documents from unreadable ones", async () => {
  const gone = { ok: false, sentence: "share.shortLink.gone" };
  expect(await readShortLink(id, answers(404, {}), pause)).toEqual(gone);
  const unknown = { ok: false, sentence: "share.linkProblems.unknown-version" };
  for (const body of [
    "<html>",
    "{}",
    { ...maze, version: 2 },
    { ...threeTasks, version: 3 },
    `${" ".repeat(70_000)}{}`,
  ]) {
    expect(await readShortLink(id, answers(200, body), pause)).toEqual(unknown);
  }
});

it("sends no request for an invalid short link", async () => {
  const get = vi.fn<ReturnType<typeof answers>>(answers(200, maze));
  for (const wrong of ["", "short", "../../healthz", "AAAAAAAAAAAA/x", "é".repeat(12)]) {
    expect(await readShortLink(wrong, get, pause)).toMatchObject({
      sentence: "share.shortLink.gone",
    });
  }
  expect(get).not.toHaveBeenCalled();
});

it("throws if the service does not respond, so that it can be retried", async () => {
  await expect(readShortLink(id, answers(503, ""), pause)).rejects.toThrow("503");
  await expect(
    readShortLink(id, () => Promise.reject(new Error("offline")), pause),
  ).rejects.toThrow("offline");
});

it("waits while the service checks the codes of classmates, and opens then", async () => {
  pause.mockClear();
  const get = vi
    .fn<ReturnType<typeof answers>>(answers(200, maze))
    .mockImplementationOnce(answers(429, ""))
    .mockImplementationOnce(answers(429, ""));
  expect(await readShortLink(id, get, pause)).toEqual({ ok: true, value: { maze } });
  expect(pause).toHaveBeenCalledTimes(2);
  expect(await readShortLink(id, answers(429, ""), pause)).toEqual({
    ok: false,
    sentence: "share.shortLink.wait",
  });
});
