/** The load process, as those see it who measure. */
import { fork, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import type { Answer, FloodJob, Job, OpenJob, PacedJob, Seen } from "./jobs.ts";

export class Load {
  readonly #child: ChildProcess;

  private constructor(child: ChildProcess) {
    this.#child = child;
  }

  static start(): Load {
    return new Load(
      fork(join(import.meta.dirname, "load-process.ts"), { serialization: "advanced" }),
    );
  }

  /** @returns the number of the fleet */
  async open(job: Omit<OpenJob, "kind">): Promise<number> {
    return (await this.#ask({ kind: "open", ...job })).fleet;
  }

  async paced(job: Omit<PacedJob, "kind">): Promise<Seen> {
    return this.#see({ kind: "paced", ...job });
  }

  async flood(job: Omit<FloodJob, "kind">): Promise<Seen> {
    return this.#see({ kind: "flood", ...job });
  }

  async close(fleet: number): Promise<void> {
    await this.#ask({ kind: "close", fleet });
  }

  async stop(): Promise<void> {
    const ended = once(this.#child, "exit");
    this.#child.disconnect();
    await ended;
  }

  async #see(job: Job): Promise<Seen> {
    const { seen } = await this.#ask(job);
    if (seen === null) throw new Error("the load saw nothing");
    return seen;
  }

  async #ask(job: Job): Promise<Answer> {
    const waiting = new AbortController();
    const ended = once(this.#child, "exit", { signal: waiting.signal }).then(() => {
      throw new Error("the load process ended; its own words stand above");
    });
    const answered = once(this.#child, "message", { signal: waiting.signal });
    this.#child.send(job);
    try {
      const [answer] = (await Promise.race([answered, ended])) as [Answer];
      return answer;
    } finally {
      waiting.abort();
      ended.catch(() => undefined);
    }
  }
}
