/** Runs remote scripts as separate processes. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { inPath } from "../../scripts/programs.ts";

const examples = fileURLToPath(new URL("../../examples/", import.meta.url));

export type ExampleLanguage = "Python" | "JavaScript" | "Java";

/** The command that runs the example of a language. */
export function exampleCommand(language: ExampleLanguage): string[] {
  return {
    Python: [inPath("python3")[0] ?? "python3", `${examples}python/right_wall.py`],
    JavaScript: [process.execPath, `${examples}javascript/right-wall.ts`],
    Java: [inPath("java")[0] ?? "java", `${examples}java/Robot.java`],
  }[language];
}

/** Runs a command until it exits. @returns its exit code and all its output */
export async function runScript(
  [command = "", ...args]: string[],
  input = "",
  env: NodeJS.ProcessEnv = process.env,
): Promise<{ code: unknown; output: string }> {
  const script = spawn(command, args, { stdio: ["pipe", "pipe", "pipe"], env });
  let output = "";
  script.stdout.on("data", (chunk) => (output += chunk));
  script.stderr.on("data", (chunk) => (output += chunk));
  script.stdin.end(input);
  const [code] = await once(script, "close");
  return { code, output };
}
