/**
 * A hidden page keeps driving. A frozen page is reported as paused, and does not run stale commands
 * when it resumes.
 */
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import { RawChromium } from "../../support/devtools.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow, sleep, waitUntil } from "../clock.ts";
import { percentile } from "../percentile.ts";
import type { Scenario } from "../scenario.ts";
import { BareSocketScript } from "../scripts/bare-socket-script.ts";

const HIDDEN_MS = 60_000;
/** longer than the time to live of the commands sent during the freeze */
const FROZEN_MS = 5_000;
/** Chromium stops the worker of a tab only some time after a request to freeze it: up to 14 s. */
const FREEZE_TIMEOUT_MS = 40_000;
const STALE = 5;

export const hiddenPage: Scenario = {
  title: "Hidden, frozen",
  describe: () =>
    `A real tab is hidden for ${HIDDEN_MS / 1000} s and receives commands one by one. Then it is frozen, and a script sends ${STALE} commands with a time to live of 2 s, ${FROZEN_MS / 1000} s before the tab resumes`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const browser = await RawChromium.start();
    context.onCleanup(() => browser.close());
    const page = await browser.open(`${relay.url}/`);
    await page.waitFor(`document.querySelector('input[value="remote"]') !== null`);
    await page.evaluate(`document.querySelector('input[value="remote"]').click()`);
    const text = await page.waitFor(`sessionStorage.getItem("corridor.remote")`);
    const { id, driverKey } = JSON.parse(String(text));
    const script = await BareSocketScript.connect(relay.url, id, driverKey);
    context.onCleanup(() => script.close());

    await browser.open("about:blank");
    await page.waitFor(`document.visibilityState === "hidden"`);
    const starts: number[] = [];
    for (const end = machineNow() + HIDDEN_MS; machineNow() < end;) {
      const record = await script.run({ action: starts.length % 2 === 0 ? "left 90" : "right 90" });
      starts.push(script.startedMs(record.seq));
    }
    const state = await page.evaluate("document.visibilityState");
    context.log(`half of the commands started within ${percentile(starts, 50).toFixed(1)} ms`);

    await page.setFrozen(true);
    const requestedAt = machineNow();
    const waitedMs = await waitUntil(() => script.robotState === "paused", FREEZE_TIMEOUT_MS);
    const notifiedMs = requestedAt + waitedMs - script.lastTickAt;
    context.log(
      `frozen ${((script.lastTickAt - requestedAt) / 1000).toFixed(1)} s after the request`,
    );
    const stale: number[] = [];
    for (let n = 0; n < STALE; n++) {
      stale.push(await script.post({ action: "move", distance: 50, ttl: 2_000 }));
    }
    await sleep(FROZEN_MS);
    await page.setFrozen(false);
    await waitUntil(() => script.robotState === "running", 20_000);
    await sleep(2_000);
    const robot = `${relay.url}/api/v1/robots/${id}/commands/`;
    const records: CommandRecord[] = [];
    for (const seq of stale) {
      const headers = { authorization: `Bearer ${driverKey}` };
      const answer = await fetch(`${robot}${seq}?wait=5`, { headers });
      records.push(commandRecordSchema.parse(await answer.json()));
    }
    return [
      {
        label: "commands started while hidden",
        measured: state === "hidden" ? starts.length : 0,
        bound: { atLeast: 50 },
        unit: "commands",
      },
      {
        label: "post to start while hidden, longest",
        measured: Math.max(...starts),
        bound: { atMost: 250 },
        unit: "ms",
      },
      {
        label: "from the frozen robot's last tick until scripts are notified",
        measured: notifiedMs,
        bound: { atMost: 5_000 },
        unit: "ms",
      },
      {
        label: "commands sent during the freeze that ran after it",
        measured: records.filter((each) => each.state !== "expired").length,
        bound: { atMost: 0 },
        unit: `of ${records.length}`,
      },
      {
        label: "commands sent during the freeze that started",
        measured: stale.filter((seq) => Number.isFinite(script.startedMs(seq))).length,
        bound: { atMost: 0 },
        unit: `of ${stale.length}`,
      },
    ];
  },
};
