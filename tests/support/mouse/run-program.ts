/** Runs a micromouse program as a process, and records what it sends and receives. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { onTestFinished } from "vitest";

export interface ProgramRun {
  /** what the program sent (`> `) and received (`< `) */
  transcript: string[];
  /** what it logged */
  log: string;
  exitCode: number | null;
}

/**
 * @param receive reads a line of the program, and calls `respond` with a line for it
 */
export async function runProgram(
  [command, ...args]: readonly [string, ...string[]],
  receive: (line: string, respond: (line: string) => void) => void | Promise<void>,
): Promise<ProgramRun> {
  const program = spawn(command, args, { stdio: ["pipe", "pipe", "pipe"] });
  onTestFinished(() => void program.kill());
  const closed = once(program, "close");
  const transcript: string[] = [];
  let log = "";
  program.stderr.setEncoding("utf8").on("data", (text: string) => (log += text));
  const respond = (line: string): void => {
    transcript.push(`< ${line}`);
    program.stdin.write(`${line}\n`);
  };
  let rest = "";
  for await (const text of program.stdout.setEncoding("utf8") as AsyncIterable<string>) {
    const lines = (rest + text).split("\n");
    rest = lines.pop() ?? "";
    for (const line of lines) {
      transcript.push(`> ${line}`);
      await receive(line, respond);
    }
  }
  const [exitCode] = (await closed) as [number | null];
  return { transcript, log, exitCode };
}
