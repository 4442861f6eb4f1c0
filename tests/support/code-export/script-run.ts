/** Programs as code, run as separate processes. */
import { execFile, spawn } from "node:child_process";
import { once } from "node:events";
import { dirname } from "node:path";
import { createInterface } from "node:readline";
import { promisify } from "node:util";
import type { CodeLanguage } from "@corridor/program";
import { inPath } from "../../../scripts/programs.ts";
import { compilerOptions, shortRunOptions } from "../java.ts";

/** Decisions of a script after which it is ended: some programs have no end. */
export const DECISIONS = 16;
/** the last line of a script whose robot has reached the goal */
export const GOAL = "The robot has reached the goal.";

const compile = promisify(execFile);

interface Runtime {
  needs: readonly string[];
  /** @returns the command that runs a file, which it compiles first where the language needs that */
  start: (file: string) => Promise<string[]>;
}

/** Mono stands in for .NET. */
export const runtimes: Record<CodeLanguage, Runtime> = {
  python: { needs: ["python3"], start: async (file) => [inPath("python3")[0] ?? "", file] },
  javascript: { needs: [], start: async (file) => [process.execPath, file] },
  java: {
    needs: ["javac", "java"],
    start: async (file) => {
      await compile("javac", [...compilerOptions, "-d", dirname(file), file]);
      return ["java", ...shortRunOptions, "-cp", dirname(file), "Rules"];
    },
  },
  csharp: {
    needs: ["mcs", "mono"],
    start: async (file) => {
      await compile("mcs", ["-r:System.Net.Http", file]);
      return ["mono", file.replace(/\.cs$/, ".exe")];
    },
  },
};

/** @returns a program of the language that is not installed; undefined: none */
export function missingProgram(language: CodeLanguage): string | undefined {
  return runtimes[language].needs.find((name) => inPath(name).length === 0);
}

export interface ScriptRun {
  /** labels of the decisions, such as "line 1" */
  lines: string[];
  /** the last printed line if the script ended by itself, and its exit code */
  end: { sentence: string; code: number } | null;
}

/**
 * Runs a script to its end, or until it has made many decisions.
 * @param onDecision called with the number of decisions
 */
export async function runScript(
  [command = "", ...args]: string[],
  onDecision: (count: number) => void = () => undefined,
): Promise<ScriptRun> {
  const script = spawn(command, args, { stdio: ["ignore", "pipe", "pipe"] });
  const closed = once(script, "close");
  const lines: string[] = [];
  let sentence = "";
  let errors = "";
  script.stderr.on("data", (chunk) => (errors += chunk));
  let isKilled = false;
  for await (const text of createInterface({ input: script.stdout })) {
    const label = /^(line \d+|otherwise): /.exec(text)?.[1];
    if (label === undefined) sentence = text;
    else onDecision(lines.push(label));
    if (lines.length < DECISIONS || isKilled) continue;
    isKilled = script.kill("SIGKILL");
  }
  const [code] = (await closed) as [number | null];
  return { lines, end: code === null ? null : { sentence: `${errors}${sentence}`.trim(), code } };
}
