/**
 * A client sends wrong pairing codes all the time. A script with the right code, from the same
 * network, still gets access within seconds.
 */
import { RobotClient } from "@corridor/client";
import { PAIRING_LETTERS } from "@corridor/protocol";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import type { Goal } from "../../../benches/core/goals.ts";
import { RawChromium, type RawPage } from "../../support/devtools.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow, sleep } from "../clock.ts";
import type { Scenario } from "../scenario.ts";

/** wrong codes per second */
const RATES = [1, 40, 120];
/** A robot has at most 12 keys, and each time adds one. */
const timesOf = (isLong: boolean): number => (isLong ? 10 : 5);
/** The queue of the relay is then as full as it gets. */
const LEAD_MS = 3_000;
/** 50 codes wait before the right one at most, and the relay checks 5 per second. */
const SLOWEST_MS = 12_000;
const TIMEOUT_MS = 60_000;
const ACCEPT_POLL_MS = 50;

export const wrongCodes: Scenario = {
  title: "Wrong pairing codes",
  describe: (isLong) =>
    `A client sends ${RATES.join(", ")} wrong pairing codes per second. From the same address, a script with the right code requests access to a real tab ${timesOf(isLong)} times, and the owner accepts`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const browser = await RawChromium.start();
    context.onCleanup(() => browser.close());
    const random = new SeededRandom(context.seed);
    const goals: Goal[] = [];
    for (const rate of RATES) {
      const page = await openRobot(browser, relay);
      const flood = new Flood(relay.url, rate, random);
      context.onCleanup(() => flood.stop());
      await sleep(LEAD_MS);
      const waits: number[] = [];
      for (let n = 0; n < timesOf(context.isLong); n++) waits.push(await pairOnce(relay, page));
      await flood.stop();
      context.log(`${rate} per second: ${flood.summary()}; ${waits.map(Math.round).join(", ")} ms`);
      goals.push({
        label: `at ${rate} wrong codes per second, slowest time until the script drives`,
        measured: Math.max(...waits),
        bound: { atMost: SLOWEST_MS },
        unit: "ms",
      });
    }
    return goals;
  },
};

/** Opens a tab with a robot of its own, ready to show a code. */
async function openRobot(browser: RawChromium, relay: RelayProcess): Promise<RawPage> {
  const page = await browser.open(`${relay.url}/`);
  await page.waitFor(`document.querySelector('input[value="remote"]') !== null`);
  await page.evaluate(`document.querySelector('input[value="remote"]').click()`);
  await page.waitFor(`sessionStorage.getItem("corridor.remote")`);
  await click(page, "summary", "code to type");
  return page;
}

/** @returns ms from typing the code until the script's first command has been completed */
async function pairOnce(relay: RelayProcess, page: RawPage): Promise<number> {
  await click(page, "button", "Show a code to type");
  const code = await page.waitFor(
    `[...document.querySelectorAll("dd *")].map((each) => each.textContent)
      .find((text) => /^[${PAIRING_LETTERS}]{4} [${PAIRING_LETTERS}]{4}$/.test(text))`,
  );
  const from = machineNow();
  const pairing = RobotClient.pair(relay.url, String(code), { answerTimeout: TIMEOUT_MS });
  let isOver = false;
  void pairing.finally(() => (isOver = true)).catch(() => undefined);
  while (!isOver) {
    if (machineNow() - from > TIMEOUT_MS) throw new Error("The script does not get access.");
    await page.evaluate(clickExpression("button", "Yes, let it drive"));
    await sleep(ACCEPT_POLL_MS);
  }
  const client = await pairing;
  await client.turn(3);
  const waited = machineNow() - from;
  client.close();
  return waited;
}

/** Clicks the first element with a text, once it is there. */
async function click(page: RawPage, tag: string, text: string): Promise<void> {
  await page.waitFor(clickExpression(tag, text));
}

/** Clicks the first element with a text. Evaluates to whether there is one. */
function clickExpression(tag: string, text: string): string {
  return `(() => {
    const found = [...document.querySelectorAll(${JSON.stringify(tag)})].find(
      ({ textContent }) => textContent.includes(${JSON.stringify(text)}));
    found?.click();
    return found !== undefined;
  })()`;
}

/** A client that sends different wrong codes at a constant rate, without waiting for answers. */
class Flood {
  readonly #url: string;
  readonly #random: SeededRandom;
  readonly #timer: NodeJS.Timeout;
  readonly #statuses = new Map<number, number>();
  readonly #requests = new Set<Promise<void>>();
  readonly #start = machineNow();
  #sent = 0;

  constructor(origin: string, perSecond: number, random: SeededRandom) {
    this.#url = `${origin}/api/v1/pairing`;
    this.#random = random;
    this.#timer = setInterval(() => {
      while (this.#sent < ((machineNow() - this.#start) / 1000) * perSecond) this.#send();
    }, 5);
  }

  /** How many codes were sent, and how many answers had each status. */
  summary(): string {
    const statuses = [...this.#statuses].map(([status, count]) => `${count} x ${status}`);
    return `${this.#sent} wrong codes, ${statuses.join(", ")}`;
  }

  async stop(): Promise<void> {
    clearInterval(this.#timer);
    await Promise.all(this.#requests);
  }

  #send(): void {
    this.#sent += 1;
    const letters = Array.from(PAIRING_LETTERS);
    const code = Array.from({ length: 8 }, () => this.#random.pick(letters)).join("");
    const request = this.#ask(code).finally(() => this.#requests.delete(request));
    this.#requests.add(request);
  }

  async #ask(code: string): Promise<void> {
    const headers = { "Content-Type": "application/json" };
    const body = JSON.stringify({ code });
    const answer = await fetch(this.#url, { method: "POST", headers, body }).catch(() => null);
    await answer?.text();
    const status = answer?.status ?? 0;
    this.#statuses.set(status, (this.#statuses.get(status) ?? 0) + 1);
  }
}
