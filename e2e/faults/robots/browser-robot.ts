/**
 * A robot in a real Chromium tab, with a script of plain requests that waits for each command to
 * end.
 */
import { commandRecordSchema, hasEnded, type CommandRecord, type Order } from "@corridor/protocol";
import { randomUUID } from "node:crypto";
import type { RawChromium, RawPage } from "../../support/devtools.ts";
import { machineNow, sleep } from "../clock.ts";

const TIMEOUT_MS = 90_000;
const RETRY_MS = 50;

export class BrowserRobot {
  readonly page: RawPage;
  readonly #url: string;
  readonly #headers: Record<string, string>;

  private constructor(page: RawPage, origin: string, { id, driverKey }: Record<string, string>) {
    this.page = page;
    this.#url = `${origin}/api/v1/robots/${id}`;
    this.#headers = {
      authorization: `Bearer ${driverKey}`,
      "content-type": "application/json",
    };
  }

  /**
   * Opens a tab with Remote as its driver.
   * @param before source of a script that runs before those of the page
   */
  static async open(
    browser: RawChromium,
    origin: string,
    before: string | null = null,
  ): Promise<BrowserRobot> {
    const page = await browser.open("about:blank");
    if (before !== null) await page.addInitScript(before);
    await page.evaluate(`location.href = ${JSON.stringify(`${origin}/`)}`);
    await page.waitFor(`document.querySelector('input[value="remote"]') !== null`);
    await page.evaluate(`document.querySelector('input[value="remote"]').click()`);
    const text = await page.waitFor(`sessionStorage.getItem("corridor.remote")`);
    return new BrowserRobot(page, origin, JSON.parse(String(text)));
  }

  /** Selects the speed. A reload resets it to 1. */
  async setSpeed(speed: string): Promise<void> {
    const select = `[...document.querySelectorAll("select")].find((each) =>
      [...each.options].some(({ value }) => value === "16"))`;
    await this.page.waitFor(`(() => {
      const select = ${select};
      if (select === undefined) return false;
      select.value = ${JSON.stringify(speed)};
      select.dispatchEvent(new Event("change", { bubbles: true }));
      return true;
    })()`);
  }

  /** Sends a command, repeats it while there is no answer, and waits until it ends. */
  async run(order: Order): Promise<CommandRecord> {
    const key = randomUUID();
    const body = JSON.stringify({ ...order, ttl: 60_000 });
    const headers = { ...this.#headers, "idempotency-key": key };
    const from = machineNow();
    let record: CommandRecord | null = null;
    while (machineNow() - from < TIMEOUT_MS) {
      const path = record === null ? "/commands" : `/commands/${record.seq}?wait=5`;
      const request = record === null ? { method: "POST", headers, body } : { headers };
      const answer = await this.#call(path, request);
      if (answer !== null) record = commandRecordSchema.parse(answer);
      else await sleep(RETRY_MS);
      if (record !== null && hasEnded(record.state)) return record;
    }
    throw new Error(`A command did not end: ${JSON.stringify(record)}`);
  }

  /** @returns null if the relay does not answer */
  async #call(path: string, request: RequestInit): Promise<unknown> {
    try {
      const answer = await fetch(`${this.#url}${path}`, {
        ...request,
        signal: AbortSignal.timeout(10_000),
      });
      return answer.ok ? await answer.json() : null;
    } catch {
      return null;
    }
  }
}
