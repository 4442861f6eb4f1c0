/** Scripts that go on sending commands of all kinds while something breaks. */
import { hasEnded } from "@corridor/protocol";
import type { Dice } from "../../apps/relay/src/testing/faults/dice.ts";
import { sleep, until } from "./clock.ts";
import { anyOrder } from "./orders.ts";
import type { Robot } from "./robots/robot.ts";
import type { Script } from "./scripts/script.ts";

/** Nothing is judged by it: a command that has not ended then never will. */
const PATIENCE_MS = 60_000;
const ASK_MS = 500;

export class Traffic {
  readonly #dice: Dice;
  readonly #scripts: readonly Script[];
  #isFlowing = true;
  readonly #flows: Promise<void>[];

  /** @param perSecond commands of each script, about */
  constructor(scripts: readonly Script[], perSecond: number, dice: Dice) {
    this.#dice = dice;
    this.#scripts = scripts;
    this.#flows = scripts.map((script) => this.#flow(script, 2_000 / perSecond));
  }

  /**
   * Sends nothing more, and waits until all that was sent has been answered and has ended.
   * @param origin of a relay that nothing disturbs any more
   */
  async settle(robots: readonly Robot[], origin: string): Promise<void> {
    this.#isFlowing = false;
    await Promise.all(this.#flows);
    const isAnswered = (): boolean => this.#scripts.every(({ diary }) => diary.unanswered === 0);
    await until(isAnswered, PATIENCE_MS);
    // A motion without an end goes on for as long as its script is there.
    for (const script of this.#scripts) script.post({ action: "stop", ttl: PATIENCE_MS });
    await until(isAnswered, PATIENCE_MS);
    for (const robot of robots) {
      for (let waited = 0; waited < PATIENCE_MS; waited += ASK_MS) {
        const log = await robot.log(origin);
        if (log.every(({ state }) => hasEnded(state))) break;
        await sleep(ASK_MS);
      }
    }
  }

  async #flow(script: Script, longestPause: number): Promise<void> {
    while (this.#isFlowing) {
      await sleep(this.#dice.between(0, longestPause));
      // A script that gets no answers waits, as people do.
      if (this.#isFlowing && script.diary.unanswered < 8) script.post(anyOrder(this.#dice));
    }
  }
}
