import { mazePresets, writeTextMaze } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { readDocument, titleOf } from "./read-document.ts";

// cspell:ignore rechts dann Aufgabe

const json = (document: unknown): string => JSON.stringify(document, null, 2);

describe("a document that is opened", () => {
  it.each(mazePresets)("maze $id is known by its content", ({ maze }) => {
    const value = { kind: "maze", maze };
    expect(readDocument(json(maze), "other")).toEqual({ ok: true, value });
    expect(readDocument(`\uFEFF\r\n ${json(maze)}`, "other")).toEqual({ ok: true, value });
    expect(readDocument(writeTextMaze(maze), maze.name)).toEqual({ ok: true, value });
  });

  it.each(programPresets)("program $id is known by its content", ({ program }) => {
    expect(readDocument(json(program), "")).toEqual({
      ok: true,
      value: { kind: "program", program },
    });
  });

  it.each([
    { text: '{"format":"corridor/maze","version":1', path: "", expected: "a JSON document" },
    { text: "[]", path: "format", expected: 'one of "corridor/maze", "corridor/program"' },
    { text: '{"format":"other"}', path: "format", expected: 'one of "corridor/maze"' },
    { text: '{"format":5}', path: "format", expected: 'one of "corridor/maze"' },
    { text: '{"format":"toString"}', path: "format", expected: 'one of "corridor/maze"' },
    { text: '{"format":"corridor/program"}', path: "version", expected: "version 1" },
    { text: "", path: "", expected: "a maze, line by line" },
    { text: "if right > 60 then right 90\notherwise forward", path: "", expected: "a program as" },
    { text: "wenn rechts > 60, dann rechts 90", path: "", expected: "a program as" },
    { text: '```json\n{"format":"corridor/program"}\n```', path: "", expected: "a program as" },
    { text: "####\n#S>60\n####", path: "line 2, column 4", expected: "" },
    { text: "#####\n#S.", path: "line 2", expected: "5 squares" },
  ])("is refused by place: $text", ({ text, path, expected }) => {
    const read = readDocument(text, "");
    expect(read.ok ? [] : read.problems).toContainEqual(
      expect.objectContaining({ path, expected: expect.stringContaining(expected) }),
    );
  });

  it("never throws", () => {
    fc.assert(
      fc.property(fc.oneof(fc.string({ unit: "binary" }), fc.json()), (text) => {
        const read = readDocument(text, "");
        return read.ok || read.problems.length > 0;
      }),
    );
  });

  it.each([
    ["my-maze.maze.json", "my-maze"],
    ["Aufgabe 3.txt", "Aufgabe 3"],
    ["v1.2 of the maze", "v1.2 of the maze"],
    ["maze", "maze"],
    ["Clipboard", "Clipboard"],
  ])("in %s is called %s", (file, title) => {
    expect(titleOf(file)).toBe(title);
  });
});

it("reads a document whose type is not its first member", () => {
  const [preset] = mazePresets;
  const { format, ...rest } = preset?.maze ?? { format: "" };
  const read = readDocument(json({ ...rest, format }), "");
  expect(read).toEqual({ ok: true, value: { kind: "maze", maze: preset?.maze } });
});
