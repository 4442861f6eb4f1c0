/**
 * As many commands as are taken, 64 on their way. The product answers once a command is on disk, and then
 * brings it to the page, which begins and ends it, both on disk again. With everybody else a command goes to
 * the page, and the page's answer back.
 */
import type { Goal } from "../core/goals.ts";
import { contenderNames } from "./contenders/contender.ts";
import { costEach, measureInTurn, quantileOf, rate, timesAsMuch, typical } from "./rounds.ts";
import { printRow, withContenders, type Section } from "./section.ts";

/** A key sends 20 commands a second, so it takes many to keep the relay busy. */
const CROWD = { robots: 400, scripts: 400, isDurable: true };
const IN_FLIGHT = 64;
const SECONDS = 2;
const ROUNDS = 3;

export const commands: Section = {
  title: "Commands",
  measure: () =>
    withContenders(contenderNames, CROWD, async (entered, load): Promise<readonly Goal[]> => {
      const flood = { of: "commands", inFlight: IN_FLIGHT, seconds: SECONDS } as const;
      const rounds = await measureInTurn(
        new Map(
          entered.map(({ name, fleet, running: { pids } }) => [
            name,
            () => load.flood({ fleet, pids, ...flood }),
          ]),
        ),
        ROUNDS,
      );
      const bare = rounds.get("bare") ?? [];
      const head = ["a second", "against bare", "p50, us", "p99, us", "us of cpu each"];
      printRow(`${IN_FLIGHT} on their way`, head);
      for (const [name, seen] of rounds) {
        printRow(name, [
          typical(seen, rate),
          timesAsMuch(seen, bare, rate),
          typical(seen, quantileOf("answers", 0.5)),
          typical(seen, quantileOf("answers", 0.99)),
          typical(seen, costEach),
        ]);
      }
      return [
        {
          words: "commands answered after their commit, against the bare forwarder's round trips",
          measured: timesAsMuch(rounds.get("corridor") ?? [], bare, rate),
          bound: { atLeast: 0.55 },
          unit: "times",
        },
      ];
    }),
};
