/** Two relays on one Redis behind a balancer; one of them is killed, then the other. */
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { startBalancer } from "../../../scripts/balancer.ts";
import { requireRedis, startRedis } from "../../../scripts/redis-server.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { machineNow, sleep, until } from "../clock.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 8;
const PER_SECOND = 4;
const EVERY_MS = 10_000;
const SHORT_KILLS = 4;
const LONG_KILLS = 60;

const killsOf = (isLong: boolean): number => (isLong ? LONG_KILLS : SHORT_KILLS);

export const twoRelays: Row = {
  title: "Two relays",
  does: (isLong) =>
    `two relays on one Redis behind a balancer, ${killsOf(isLong)} times one of them is killed (kill -9) and comes back after ${EVERY_MS / 2000} s, while ${ROBOTS} robots get commands by all ways`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    requireRedis();
    const redis = await startRedis(terms.folder);
    terms.after(() => redis.stop("SIGKILL"));
    const environment = { STORE_URL: redis.url };
    const relays = [
      await RelayProcess.start({ environment }),
      await RelayProcess.start({ environment }),
    ] as const;
    for (const relay of relays) terms.after(() => relay.stop());
    const balancer = await startBalancer(
      relays.map(({ port }) => port),
      0,
      "127.0.0.1",
    );
    terms.after(() => balancer.close());
    const origin = `http://127.0.0.1:${balancer.port}`;

    const scene = new Scene(terms);
    await scene.register(origin, ROBOTS);
    const pages = await scene.startPages();
    // The line over HTTPS lives at one relay, and this balancer knows nothing of robots.
    for (const robot of scene.robots) scene.open(robot, pages, origin, "websocket");
    await scene.allConnected();
    const scripts = await scene.scripts(() => origin, ["websocket", "requests"]);
    const traffic = new Traffic(scripts, PER_SECOND, dice);

    const backMs: number[] = [];
    for (let n = 0; n < killsOf(terms.isLong); n++) {
      const next = machineNow() + EVERY_MS;
      await sleep(dice.between(500, 2_000));
      const [killed, other] = n % 2 === 0 ? relays : [relays[1], relays[0]];
      const killedAt = machineNow();
      await killed.kill();
      balancer.targets = [other.port];
      // Those of the other relay have noticed nothing.
      const isBack = (): boolean =>
        scene.robots.every(
          ({ isConnected, lostAt, connectedAt }) =>
            isConnected && (lostAt < killedAt || connectedAt > lostAt),
        );
      await sleep(100);
      await until(isBack, 60_000);
      backMs.push(machineNow() - killedAt);
      await sleep(EVERY_MS / 2 - (machineNow() - killedAt));
      await killed.restart();
      balancer.targets = relays.map(({ port }) => port);
      await sleep(next - machineNow());
    }
    await traffic.settle(scene.robots, origin);
    const compared = await scene.compare(origin);
    return [
      ...compared.goals(),
      {
        label: "robots back after a kill",
        measured: Math.max(...backMs),
        bound: { atMost: 5_000 },
        unit: "ms",
      },
    ];
  },
};
