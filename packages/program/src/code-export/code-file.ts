/**
 * A program as one file of code that drives the robot over the network, through the same poses as
 * the program. The lines are on top, as if and else; the calls of the robot's service are below.
 * Each file needs only the standard library of its language.
 */
import type { ProgramDocument } from "../program-document.ts";
import type { CodeContent } from "./code-text.ts";
import { csharpCode } from "./csharp-code.ts";
import { javaCode } from "./java-code.ts";
import { javascriptCode } from "./javascript-code.ts";
import { pythonCode } from "./python-code.ts";
import { scriptLines, type ScriptLines } from "./script-lines.ts";

export const codeLanguages = ["python", "javascript", "java", "csharp"] as const;
export type CodeLanguage = (typeof codeLanguages)[number];

/** How to save and start a file. */
export const codeFiles: Readonly<
  Record<CodeLanguage, { file: string; command: string; needs: string }>
> = {
  python: { file: "rules.py", command: "python3 rules.py", needs: "Python 3.8" },
  javascript: { file: "rules.mjs", command: "node rules.mjs", needs: "Node 18" },
  java: { file: "Rules.java", command: "java Rules.java", needs: "Java 11" },
  csharp: { file: "Rules.cs", command: "dotnet run Rules.cs", needs: ".NET 10" },
};

const writers: Readonly<Record<CodeLanguage, (content: CodeContent) => string>> = {
  python: pythonCode,
  javascript: javascriptCode,
  java: javaCode,
  csharp: csharpCode,
};

export type ProgramCode = { ok: true; text: string } | Extract<ScriptLines, { ok: false }>;

/** @param address of the robot, with its key, or with a masked key to display */
export function programCode(
  program: ProgramDocument,
  language: CodeLanguage,
  address: string,
): ProgramCode {
  const script = scriptLines(program);
  if (!script.ok) return script;
  const { command } = codeFiles[language];
  const content = {
    name: program.name,
    lines: script.lines,
    address: JSON.stringify(address),
    command,
  };
  return { ok: true, text: writers[language](content) };
}
