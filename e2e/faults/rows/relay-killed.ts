/** The relay ends as by a power cut, again and again, and starts with what is in its files. */
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { machineNow, sleep, until } from "../clock.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 6;
const PER_SECOND = 4;
const EVERY_MS = 5_000;
const SHORT_KILLS = 12;
const LONG_KILLS = 120;

const kills = (isLong: boolean): number => (isLong ? LONG_KILLS : SHORT_KILLS);

export const relayKilled: Row = {
  title: "Relay killed",
  does: (isLong) =>
    `kill -9 of the relay, ${kills(isLong)} times in ${(kills(isLong) * EVERY_MS) / 1000} s, while ${ROBOTS} robots get commands by all ways`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const scene = new Scene(terms);
    await scene.register(relay.url, ROBOTS);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "both");
    await scene.allConnected();
    const scripts = await scene.scripts(() => relay.url);
    const traffic = new Traffic(scripts, PER_SECOND, dice);

    const relayMs: number[] = [];
    const allMs: number[] = [];
    for (let n = 0; n < kills(terms.isLong); n++) {
      const next = machineNow() + EVERY_MS;
      await sleep(dice.between(500, 1_500));
      const killedAt = machineNow();
      await relay.kill();
      const goneAt = machineNow();
      await relay.restart();
      const answer = await fetch(`${relay.url}/readyz`);
      if (!answer.ok) throw new Error(`the relay came back with ${answer.status}`);
      relayMs.push(machineNow() - killedAt);
      await until(
        () =>
          scene.robots.every(
            ({ isConnected, connectedAt }) => isConnected && connectedAt > killedAt,
          ),
        30_000,
      );
      // Some are quicker than the request above, and are not welcomed twice.
      await until(() => scripts.every(({ heardAt }) => heardAt > goneAt), 30_000);
      allMs.push(machineNow() - killedAt);
      await sleep(next - machineNow());
    }
    await traffic.settle(scene.robots, relay.url);
    const compared = await scene.compare(relay.url);
    return [
      ...compared.goals(),
      {
        label: "relay back after a kill",
        measured: Math.max(...relayMs),
        bound: { atMost: 2_000 },
        unit: "ms",
      },
      {
        label: "robots and scripts back after a kill",
        measured: Math.max(...allMs),
        bound: { atMost: 5_000 },
        unit: "ms",
      },
    ];
  },
};
