/**
 * The cost of storing the world before an ending is sent, measured against a page that cannot store
 * it.
 */
import { RawChromium } from "../../support/devtools.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow } from "../clock.ts";
import { percentile } from "../percentile.ts";
import { BrowserRobot } from "../robots/browser-robot.ts";
import type { Scenario } from "../scenario.ts";

const SHORT_TIMES = 100;
const LONG_TIMES = 500;

/** Storing the run fails in this tab, so that endings are sent immediately. */
const STORES_NOTHING = `
  const setItem = Storage.prototype.setItem;
  Storage.prototype.setItem = function (key, text) {
    if (key === "corridor.run") throw new DOMException("full", "QuotaExceededError");
    setItem.call(this, key, text);
  };
`;

export const savedEndings: Scenario = {
  title: "Saved endings",
  describe: (isLong) =>
    `Scripts send ${isLong ? LONG_TIMES : SHORT_TIMES} turns alternately to a tab that stores its world and to one that cannot`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const browser = await RawChromium.start();
    context.onCleanup(() => browser.close());
    const storing = await BrowserRobot.open(browser, relay.url);
    const other = await BrowserRobot.open(browser, relay.url, STORES_NOTHING);
    const robots = [
      { robot: storing, took: new Array<number>() },
      { robot: other, took: new Array<number>() },
    ];
    for (const { robot } of robots) {
      await robot.setSpeed("16");
      await robot.run({ action: "turn", degrees: 11 });
    }
    for (let n = 0; n < (context.isLong ? LONG_TIMES : SHORT_TIMES); n++) {
      for (const { robot, took } of robots) {
        const from = machineNow();
        await robot.run({ action: "turn", degrees: 11 });
        took.push(machineNow() - from);
      }
    }
    const [saved = Infinity, unsaved = 0] = robots.map(({ took }) => percentile(took, 50));
    const key = `sessionStorage.getItem("corridor.run") !== null`;
    const isStored = [await storing.page.evaluate(key), await other.page.evaluate(key)];
    context.log(
      `the median turn took ${saved.toFixed(1)} ms, and ${unsaved.toFixed(1)} ms without storing`,
    );
    return [
      {
        label: "one tab stores its world, the other does not",
        measured: isStored[0] === true && isStored[1] === false ? 1 : 0,
        bound: { atLeast: 1 },
        unit: "",
      },
      {
        label: "time added to the median turn by storing",
        measured: saved - unsaved,
        bound: { atMost: 10 },
        unit: "ms",
      },
    ];
  },
};
