import { describe, expect, it } from "vitest";
import { fileName } from "./save-picture.ts";

describe("the name of a saved picture", () => {
  it.each([
    { name: "Long way round", file: "long-way-round" },
    { name: "../../etc/passwd", file: "etc-passwd" },
    { name: "Labyrinth Nº 3 – schön", file: "labyrinth-nº-3-schön" },
    { name: "迷路", file: "迷路" },
    { name: "", file: "maze" },
    { name: "***", file: "maze" },
  ])("is $file for $name", ({ name, file }) => {
    expect(fileName(name)).toBe(file);
  });
});
