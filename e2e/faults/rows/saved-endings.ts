/**
 * What it costs that an ending is sent only once its world is stored: beside a page that cannot
 * store it.
 */
import { RawChromium } from "../../support/devtools.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { machineNow } from "../clock.ts";
import { percentile } from "../percentile.ts";
import { RealRobot } from "../robots/real-robot.ts";
import type { Row } from "../row.ts";

const SHORT_TIMES = 100;
const LONG_TIMES = 500;

/** The tab notes no key, so that nothing is stored and endings are sent at once. */
const STORES_NOTHING = `
  const setItem = Storage.prototype.setItem;
  Storage.prototype.setItem = function (key, text) {
    if (key === "corridor.run") throw new DOMException("full", "QuotaExceededError");
    setItem.call(this, key, text);
  };
`;

export const savedEndings: Row = {
  title: "Saved endings",
  does: (isLong) =>
    `${isLong ? LONG_TIMES : SHORT_TIMES} turns by turns in a tab that stores its world and in one that cannot`,
  run: async (terms) => {
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const browser = await RawChromium.start();
    terms.after(() => browser.close());
    const storing = await RealRobot.open(browser, relay.url);
    const other = await RealRobot.open(browser, relay.url, STORES_NOTHING);
    const robots = [
      { robot: storing, took: new Array<number>() },
      { robot: other, took: new Array<number>() },
    ];
    for (const { robot } of robots) {
      await robot.setSpeed("16");
      await robot.run({ action: "turn", degrees: 11 });
    }
    for (let n = 0; n < (terms.isLong ? LONG_TIMES : SHORT_TIMES); n++) {
      for (const { robot, took } of robots) {
        const from = machineNow();
        await robot.run({ action: "turn", degrees: 11 });
        took.push(machineNow() - from);
      }
    }
    const [saved = Infinity, unsaved = 0] = robots.map(({ took }) => percentile(took, 50));
    const key = `sessionStorage.getItem("corridor.run") !== null`;
    const isStored = [await storing.page.evaluate(key), await other.page.evaluate(key)];
    terms.say(
      `half of the turns took ${saved.toFixed(1)} ms, and ${unsaved.toFixed(1)} ms unsaved`,
    );
    return [
      {
        label: "tabs that store their world",
        measured: isStored[0] === true && isStored[1] === false ? 1 : 0,
        bound: { atLeast: 1 },
        unit: "of 2, as meant",
      },
      {
        label: "later that half of the endings come because they are saved",
        measured: saved - unsaved,
        bound: { atMost: 10 },
        unit: "ms",
      },
    ];
  },
};
