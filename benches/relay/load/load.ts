/** Client of the load process. */
import { fork, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import { ask } from "./ask.ts";
import type { LoadReply, FloodJob, Job, OpenJob, PacedJob, LoadResult } from "./jobs.ts";

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

  /** Connects a fleet. @returns its number */
  async open(job: Omit<OpenJob, "kind">): Promise<number> {
    return (await this.#request({ kind: "open", ...job })).fleet;
  }

  async paced(job: Omit<PacedJob, "kind">): Promise<LoadResult> {
    return this.#run({ kind: "paced", ...job });
  }

  async flood(job: Omit<FloodJob, "kind">): Promise<LoadResult> {
    return this.#run({ kind: "flood", ...job });
  }

  async close(fleet: number): Promise<void> {
    await this.#request({ kind: "close", fleet });
  }

  async stop(): Promise<void> {
    const ended = once(this.#child, "exit");
    this.#child.disconnect();
    await ended;
  }

  async #run(job: Job): Promise<LoadResult> {
    const { result } = await this.#request(job);
    if (result === null) throw new Error("the load process returned no result");
    return result;
  }

  async #request(job: Job): Promise<LoadReply> {
    return (await ask(this.#child, job)) as LoadReply;
  }
}
