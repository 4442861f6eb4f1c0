/**
 * A snapshot's way from the page over the relay to the reader, and what it costs the relay. 15 a second of
 * each robot: the relay passes 20 a second on, so every one arrives, as with everybody else.
 */
import type { Goal } from "../core/goals.ts";
import { contenderNames } from "./contenders/contender.ts";
import {
  costEach,
  measureInTurn,
  passedShare,
  quantileOf,
  timesAsMuch,
  typical,
} from "./rounds.ts";
import { printRow, withContenders, type Section } from "./section.ts";

const CROWD = { robots: 100, scripts: 0, isDurable: false };
const A_SECOND = 15;
const SECONDS = 2;
const ROUNDS = 5;

export const snapshots: Section = {
  title: "Snapshots",
  measure: () =>
    withContenders(contenderNames, CROWD, async (entered, load): Promise<readonly Goal[]> => {
      const rounds = await measureInTurn(
        new Map(
          entered.map(({ name, fleet, running: { pids } }) => {
            const pace = { aSecond: A_SECOND, commandsASecond: 0, seconds: SECONDS };
            return [name, () => load.paced({ fleet, pids, ...pace })];
          }),
        ),
        ROUNDS,
      );
      const bare = rounds.get("bare") ?? [];
      printRow(`${CROWD.robots} robots, ${A_SECOND}/s each`, [
        "way p50, us",
        "against bare",
        "p99, us",
        "us of cpu each",
        "against bare",
        "passed on, %",
      ]);
      for (const [name, seen] of rounds) {
        printRow(name, [
          typical(seen, quantileOf("ways", 0.5)),
          timesAsMuch(seen, bare, quantileOf("ways", 0.5)),
          typical(seen, quantileOf("ways", 0.99)),
          typical(seen, costEach),
          timesAsMuch(seen, bare, costEach),
          typical(seen, passedShare),
        ]);
      }
      return [
        {
          label: "a snapshot's way, p50, against the bare forwarder",
          measured: timesAsMuch(rounds.get("corridor") ?? [], bare, quantileOf("ways", 0.5)),
          bound: { atMost: 1.2 },
          unit: "times",
        },
      ];
    }),
};
