/** A request to a load process, which replies to one request after the other. */
import type { ChildProcess } from "node:child_process";
import { once } from "node:events";

/** @throws Error if the process ends before it replies */
export async function ask(child: ChildProcess, request: object): Promise<unknown> {
  const waiting = new AbortController();
  const ended = once(child, "exit", { signal: waiting.signal }).then(() => {
    throw new Error("the load process ended; see its error above");
  });
  const replied = once(child, "message", { signal: waiting.signal });
  child.send(request);
  try {
    const [reply] = (await Promise.race([replied, ended])) as [unknown];
    return reply;
  } finally {
    waiting.abort();
    ended.catch(() => undefined);
  }
}
