/** Remote scripts as their authors start them: processes of their own. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { inPath } from "../../scripts/programs.ts";

const examples = fileURLToPath(new URL("../../examples/", import.meta.url));

/** The example of a language, as the command that runs it. */
export function exampleOf(language: "Python" | "JavaScript"): string[] {
  return language === "Python"
    ? [inPath("python3")[0] ?? "python3", `${examples}python/right_wall.py`]
    : [process.execPath, `${examples}javascript/right-wall.ts`];
}

/** Runs a command to its end. @returns its exit code and all that it printed */
export async function runScript(
  [command = "", ...words]: string[],
  input = "",
): Promise<{ code: unknown; output: string }> {
  const script = spawn(command, words, { stdio: ["pipe", "pipe", "pipe"] });
  let output = "";
  script.stdout.on("data", (chunk) => (output += chunk));
  script.stderr.on("data", (chunk) => (output += chunk));
  script.stdin.end(input);
  const [code] = await once(script, "close");
  return { code, output };
}
