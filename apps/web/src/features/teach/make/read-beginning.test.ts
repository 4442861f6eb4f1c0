import { describe, expect, it } from "vitest";
import { mazeOf, sampleLesson } from "../testing/sample-lesson.ts";
import { readBeginningFile } from "./read-beginning.ts";

function fileOf(text: string) {
  return { name: "file.json", size: text.length, text: async () => text };
}

describe("the file with which a teacher begins", () => {
  it("can be a lesson, which students may have", async () => {
    const read = await readBeginningFile(fileOf(JSON.stringify(sampleLesson)), "Task 1");
    expect(read).toEqual({ opened: { ok: true, lesson: sampleLesson }, isShared: true });
  });

  it("can be a maze, which becomes a lesson of one task", async () => {
    const maze = mazeOf("comb");
    const text = `\uFEFF${JSON.stringify(maze)}\n`;
    const { opened, isShared } = await readBeginningFile(fileOf(text), "Task 1");
    expect(isShared).toBe(false);
    expect(opened).toMatchObject({
      ok: true,
      lesson: { name: maze.name, tasks: [{ name: "Task 1", mazes: [maze] }] },
    });
  });

  it.each([
    ["a newer lesson", JSON.stringify({ ...sampleLesson, version: 3 }), "version"],
    ["a letter", "Dear parents", ""],
  ])("is refused as a lesson if it is %s", async (_, text, path) => {
    const { opened } = await readBeginningFile(fileOf(text), "Task 1");
    expect(opened).toMatchObject({ ok: false, code: "document", problems: [{ path }] });
  });
});
