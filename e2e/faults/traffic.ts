/** Scripts that keep sending commands of all kinds while faults are injected. */
import type { SeededRandom } from "../../apps/relay/src/testing/faults/seeded-random.ts";
import { sleep, waitUntil } from "./clock.ts";
import { randomCommand } from "./commands.ts";
import type { Robot } from "./robots/robot.ts";
import type { Script } from "./scripts/script.ts";

/** Commands that have not ended after this time never will. No goal depends on it. */
const TIMEOUT_MS = 60_000;

export class Traffic {
  readonly #random: SeededRandom;
  readonly #scripts: readonly Script[];
  #isSending = true;
  readonly #senders: Promise<void>[];

  /** @param perSecond approximate number of commands of each script */
  constructor(scripts: readonly Script[], perSecond: number, random: SeededRandom) {
    this.#random = random;
    this.#scripts = scripts;
    this.#senders = scripts.map((script) => this.#sendRepeatedly(script, 2_000 / perSecond));
  }

  /**
   * Stops sending, and waits until all commands have been answered and have ended.
   * @param origin of a relay without any remaining fault
   */
  async drain(robots: readonly Robot[], origin: string): Promise<void> {
    this.#isSending = false;
    await Promise.all(this.#senders);
    const isAnswered = (): boolean =>
      this.#scripts.every(({ commands }) => commands.unanswered === 0);
    await waitUntil(isAnswered, TIMEOUT_MS);
    // A motion without an end continues for as long as its script is connected.
    for (const script of this.#scripts) script.post({ action: "stop", ttl: TIMEOUT_MS });
    await waitUntil(isAnswered, TIMEOUT_MS);
    for (const robot of robots) await robot.waitUntilEnded(origin, TIMEOUT_MS);
  }

  async #sendRepeatedly(script: Script, maxPauseMs: number): Promise<void> {
    while (this.#isSending) {
      await sleep(this.#random.between(0, maxPauseMs));
      // A script without answers stops sending, as real scripts do.
      if (this.#isSending && script.commands.unanswered < 8)
        script.post(randomCommand(this.#random));
    }
  }
}
