import { describe, expect, it } from "vitest";
import { fileName } from "./file-name.ts";

// cspell:ignore schön

describe("the name of a saved file", () => {
  it.each([
    { name: "Long way round", file: "long-way-round" },
    { name: "../../etc/passwd", file: "etc-passwd" },
    { name: "Labyrinth Nº 3 – schön", file: "labyrinth-nº-3-schön" },
    { name: "迷路", file: "迷路" },
    { name: "", file: "maze" },
    { name: "***", file: "maze" },
    { name: "🤖", file: "maze" },
    { name: "𠮷".repeat(70), file: "𠮷".repeat(60) },
    { name: `${"a".repeat(59)} b`, file: "a".repeat(59) },
  ])("is $file for $name", ({ name, file }) => {
    expect(fileName(name, "maze")).toBe(file);
  });
});
