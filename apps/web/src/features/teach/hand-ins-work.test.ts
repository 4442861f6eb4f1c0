import { describe, expect, it, vi } from "vitest";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";
import type { TextFile } from "../../ui/incoming-files.ts";
import type { HandInCheck } from "./check-hand-ins.ts";
import { HandInsWork } from "./hand-ins-work.ts";
import { lessonOfShared, readShared, type OpenedLesson } from "./lessons/read-lesson.ts";
import { TeachStorage } from "./teach-storage.ts";
import { linkOf, programOf, sampleLesson } from "./testing/sample-lesson.ts";

const lessonText = JSON.stringify(sampleLesson);
const link = linkOf(programOf("right-wall", "Juniper"));

function file(name: string, text: string, size = text.length): TextFile {
  return { name, size, text: () => Promise.resolve(text) };
}

function setUp(device = new MemoryStorage()) {
  const start = vi.fn<HandInCheck["start"]>();
  const work = new HandInsWork({
    storage: new TeachStorage(device),
    check: { start, clear: () => undefined },
    readAddress: async (text): Promise<OpenedLesson> =>
      lessonOfShared(
        await readShared(text, "corridor.example", () =>
          Promise.resolve({ ok: false, sentence: "share.shortLink.gone" }),
        ),
      ),
  });
  return { device, work, start, state: () => work.store.getState() };
}

describe("the work on hand-ins", () => {
  it("continues after a reload with the same lesson and lines", async () => {
    const { device, work } = setUp();
    await work.openAddress(lessonText);
    work.setText(`${link}\n`);
    const again = setUp(device).state();
    expect(again.lesson).toEqual(sampleLesson);
    expect(again.text).toBe(`${link}\n`);
  });

  it("keeps the open lesson and the lines if another lesson cannot be opened", async () => {
    const { work, state } = setUp();
    await work.openAddress(lessonText);
    work.setText(link);
    await work.openAddress("nonsense");
    expect(state()).toMatchObject({
      lesson: sampleLesson,
      text: link,
      problem: { code: "unknown-version" },
    });
  });

  it.each([
    ["https://corridor.example/m/BCDF", "gone"],
    ["https://other.example/m/BCDF", "short-link"],
    [link, "no-lesson"],
    ['{"format":"corridor/challenge","version":3}', "document"],
  ])("states why %s is no lesson", async (text, code) => {
    const { work, state } = setUp();
    await work.openAddress(text);
    expect(state()).toMatchObject({ lesson: null, problem: { code } });
  });

  it("sorts dropped files into the lesson and the hand-ins", async () => {
    const { work, state } = setUp();
    const program = JSON.stringify(programOf("right-wall", ""));
    await work.addFiles([file("a.json", program), file("l.json", lessonText), file("b.json", "x")]);
    expect(state().lesson).toEqual(sampleLesson);
    expect(state().files.map(({ name, read }) => [name, read.ok])).toEqual([
      ["a.json", true],
      ["b.json", false],
    ]);
    await work.addFiles([file("b.json", program)]);
    expect(state().files.map(({ read }) => read.ok)).toEqual([true, true]);
  });

  it("has the files of two students with one name, and a file that is dropped again once", async () => {
    const { work, state } = setUp();
    const [right, left] = (["right-wall", "left-wall"] as const).map((id) =>
      file("mine.json", JSON.stringify(programOf(id, "Mine"))),
    );
    for (const each of [right, left, left]) if (each !== undefined) await work.addFiles([each]);
    expect(state().files).toHaveLength(2);
  });

  it("does not read a file that is too big", async () => {
    const { work, state } = setUp();
    await work.addFiles([file("film.json", "", 9_000_001)]);
    expect(state().files).toMatchObject([{ read: { ok: false, code: "file-size" } }]);
  });

  it("starts a check of the chosen tasks", async () => {
    const { work, start } = setUp();
    await work.openAddress(lessonText);
    work.addLines(link);
    work.addLines(link);
    work.chooseTask(0, false);
    work.startCheck();
    const [tasks, entries] = start.mock.calls[0] ?? [];
    expect(tasks?.map(({ number }) => number)).toEqual([2]);
    expect(entries?.map(({ source }) => source)).toEqual([{ line: 1 }, { line: 2 }]);
  });

  it.each([
    ["there is no hand-in", "", "no-hand-in"],
    ["there are too many", `${link}\n`.repeat(501), "too-many"],
  ])("refuses a check if %s, and keeps the lines", async (_, text, code) => {
    const { work, start, state } = setUp();
    await work.openAddress(lessonText);
    work.setText(text);
    work.startCheck();
    expect(state()).toMatchObject({ text, refusal: { code } });
    expect(start).not.toHaveBeenCalled();
  });

  it("refuses a check without a task", async () => {
    const { work, state } = setUp();
    await work.openAddress(lessonText);
    work.setText(link);
    work.chooseTask(0, false);
    work.chooseTask(1, false);
    work.startCheck();
    expect(state().refusal).toEqual({ code: "no-task" });
  });
});
