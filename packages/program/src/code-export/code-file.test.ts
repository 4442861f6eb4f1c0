import { SILENT_WORDS } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import type { ProgramDocument } from "../program-document.ts";
import { paperPrograms } from "../testing/paper-programs.ts";
import { codeLanguages, programCode, type CodeLanguage } from "./code-file.ts";

const ADDRESS = "https://host/r/r1#d_test-key";

const figure23 = paperPrograms.find(({ figure }) => figure === 23)?.program as ProgramDocument;

function codeOf(program: ProgramDocument, language: CodeLanguage): string[] {
  const code = programCode(program, language, ADDRESS);
  if (!code.ok) throw new Error("expected a file");
  return code.text.trimEnd().split("\n");
}

/** The lines between the head of the rules and the first line after them. */
function rulesOf(program: ProgramDocument, language: CodeLanguage): string {
  const lines = codeOf(program, language);
  const start = lines.findIndex((line) => /decide ?\(/i.test(line));
  const end = lines.findIndex((line, at) => at > start && line === "");
  return lines.slice(start, end).join("\n");
}

describe("a program as code", () => {
  it("has its lines as if and else in Python", () => {
    expect(rulesOf(figure23, "python")).toBe(`def decide(front, right, back, left):
    if front > 50:
        drive("line 1", "forward", "front <= 50")
    elif left > right + 1:
        drive("line 2", "left 90")
    elif left < right + 1:
        drive("line 3", "right 90")
    else:
        drive("otherwise", "forward", "left > right + 1 or left < right + 1")`);
  });

  it("has its lines as if and else in JavaScript", () => {
    expect(rulesOf(figure23, "javascript"))
      .toBe(`async function decide({ front, right, back, left }) {
  if (front > 50) {
    await drive("line 1", "forward", "front <= 50");
  } else if (left > right + 1) {
    await drive("line 2", "left 90");
  } else if (left < right + 1) {
    await drive("line 3", "right 90");
  } else {
    await drive("otherwise", "forward", "left > right + 1 or left < right + 1");
  }
}`);
  });

  it.each(["java", "csharp"] as const)("has the same sentences in %s", (language) => {
    const sentences = rulesOf(figure23, language)
      .split("\n")
      .slice(1)
      .map((line) => line.trim());
    expect(sentences.map((line) => line.replace(/^Drive/, "drive"))).toEqual([
      "if (front > 50) {",
      'drive("line 1", "forward", "front <= 50");',
      "} else if (left > right + 1) {",
      'drive("line 2", "left 90");',
      "} else if (left < right + 1) {",
      'drive("line 3", "right 90");',
      "} else {",
      'drive("otherwise", "forward", "left > right + 1 or left < right + 1");',
      "}",
      "}",
    ]);
  });

  it.each(["python", "javascript"] as const)("of one action has no if in %s", (language) => {
    const rules = rulesOf({ ...figure23, rules: [], default: "turn 180" }, language);
    expect(rules).not.toMatch(/\b(if|else)\b/);
    expect(rules).toContain('drive("otherwise", "turn 180")');
  });

  it("writes negative and broken numbers as the language reads them", () => {
    const when = { sensor: "left", is: "<", than: "right", plus: -0.1 } as const;
    const rules = rulesOf({ ...figure23, rules: [{ when, do: "forward" }] }, "java");
    expect(rules).toContain("if (left < right - 0.1) {");
    expect(rules).toContain('"left >= right - 0.1"');
  });
});

describe.each(codeLanguages)("a file in %s", (language) => {
  it("has at most 60 lines below the rules", () => {
    const lines = codeOf(figure23, language);
    const calls = lines.findIndex((line) => line.includes("The calls of the robot's service."));
    expect(calls).toBeGreaterThan(0);
    expect(lines.length - calls).toBeLessThanOrEqual(60);
  });

  it("decides again after the words that hosts write for a lost lease", () => {
    expect(codeOf(figure23, language).join("\n")).toContain(`"${SILENT_WORDS}"`);
  });

  it("has the address in one place", () => {
    const places = codeOf(figure23, language).filter((line) => line.includes("d_test-key"));
    expect(places).toHaveLength(1);
    expect(places[0]).toContain(`"${ADDRESS}"`);
  });

  it.each([
    "a\nb",
    "a\r\u2028\u2029\u0085b",
    String.raw`\u000a System.exit(0); //`,
    "\u202E\uD800",
    " ",
  ])("stays the same code with the name %j", (name) => {
    const [title, ...code] = codeOf({ ...figure23, name }, language);
    expect(code).toEqual(codeOf(figure23, language).slice(1));
    expect(title).toMatch(/^(#|\/\/) [^\p{C}\p{Zl}\p{Zp}\\]+$/u);
  });

  it("breaks a long list of conditions, and loses none", () => {
    const rules = Array.from({ length: 199 }, (_none, at) => ({
      when: { sensor: "front", is: "<", than: at } as const,
      do: "left 90" as const,
    }));
    const lines = codeOf({ ...figure23, rules }, language);
    const calls = lines.findIndex((line) => line.includes("The calls"));
    const text = lines.slice(0, calls);
    expect(Math.max(...text.map((line) => line.length))).toBeLessThanOrEqual(100);
    const otherwise = text.slice(text.findIndex((line) => line.includes("otherwise")) + 1);
    const conditions = [...otherwise.join("").matchAll(/"([^"]*)"/g)].map(([, part]) => part);
    expect(conditions.join("").split(" or ")).toEqual(rules.map((_rule, at) => `front < ${at}`));
  });

  it("is refused with the line whose conditions are too many", () => {
    const rule = { when: { sensor: "front", is: "<", than: 1 }, do: "left 90" } as const;
    const code = programCode({ ...figure23, rules: Array(200).fill(rule) }, language, ADDRESS);
    expect(code).toEqual({ ok: false, line: "default", conditions: 201 });
  });
});
