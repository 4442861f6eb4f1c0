/** Remote scripts as their authors start them: processes of their own. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { inPath } from "../../scripts/programs.ts";

const examples = fileURLToPath(new URL("../../examples/", import.meta.url));

export type ExampleLanguage = "Python" | "JavaScript" | "Java";

/** The example of a language, as the command that runs it. */
export function exampleOf(language: ExampleLanguage): string[] {
  return {
    Python: [inPath("python3")[0] ?? "python3", `${examples}python/right_wall.py`],
    JavaScript: [process.execPath, `${examples}javascript/right-wall.ts`],
    Java: [inPath("java")[0] ?? "java", `${examples}java/Robot.java`],
  }[language];
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
