/**
 * `corridor` in the process of the test. A process of its own takes about a second of processor
 * time, and proves nothing more about a text than one that is started once.
 */
import { vi } from "vitest";
import { runCommandLine } from "../../../apps/cli/src/command-line.ts";
import { runProcess } from "../../../apps/cli/src/run-command.ts";

const entry = new URL("../../../apps/cli/src/main.ts", import.meta.url);

/** Runs a command that starts no worker threads, reads no standard input, and does not exit. */
export async function corridorHere(
  ...args: string[]
): Promise<{ code: number; out: string; bytes: Buffer; errors: string }> {
  const codeBefore = process.exitCode;
  const out: Uint8Array[] = [];
  const errors: Uint8Array[] = [];
  const capture = (stream: NodeJS.WriteStream, into: Uint8Array[]) =>
    vi.spyOn(stream, "write").mockImplementation((content: string | Uint8Array) => {
      into.push(typeof content === "string" ? Buffer.from(content) : content);
      return true;
    });
  const spies = [capture(process.stdout, out), capture(process.stderr, errors)];
  try {
    await runProcess(async () => runCommandLine(args, entry));
    const bytes = Buffer.concat(out);
    const code = Number(process.exitCode);
    return { code, out: bytes.toString(), bytes, errors: Buffer.concat(errors).toString() };
  } finally {
    for (const spy of spies) spy.mockRestore();
    process.exitCode = codeBefore;
  }
}
