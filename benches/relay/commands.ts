/**
 * As many commands as are taken, 64 on their way. The product answers once a command is on disk, which is what is
 * judged: at robots that are busy, so that those that come wait. With everybody else a command goes to the page, and
 * the page's answer back. And its whole life: brought to the page as well, which begins and ends it, both on disk again.
 */
import type { Goal } from "../core/goals.ts";
import { contenderNames, type ContenderName } from "./contenders/contender.ts";
import type { Seen } from "./load/jobs.ts";
import { whenQuiet } from "./quiet.ts";
import { costEach, measureInTurn, quantileOf, rate, timesAsMuch, typical } from "./rounds.ts";
import { printRow, withContenders, type Crowd, type Section } from "./section.ts";

/** A key sends 20 commands a second, so it takes many to keep the relay busy. */
const FREE = { robots: 400, scripts: 400 };
/**
 * A busy robot's page has as many as it may have, so that what comes is kept and waits. Of these there may be 64, and
 * a round is to bring no robot as many: a refusal ends it all.
 */
const BUSY = { robots: 1500, scripts: 1500, isBusy: true };
const IN_FLIGHT = 64;
const SECONDS = 2;
/** The first ones are slower, while new code is compiled: these are some 100,000 commands. */
const FIRST_ROUNDS = 4;
const ROUNDS = 7;

export const commands: Section = {
  title: "Commands",
  measure: async (): Promise<readonly Goal[]> => {
    const head = ["a second", "against bare", "p50, us", "p99, us", "us of cpu each"];
    printRow(`${IN_FLIGHT} on their way`, head);
    const answered = await flooded(["bare", "corridor"], BUSY);
    printRow("whole lives", head);
    await flooded(contenderNames, FREE);
    return [
      {
        label: "commands answered after their commit, against the bare forwarder's round trips",
        measured: timesAsMuch(answered.get("corridor") ?? [], answered.get("bare") ?? [], rate),
        bound: { atLeast: 0.55 },
        unit: "times",
      },
    ];
  },
};

/** A row for each contender. @returns what each round saw */
function flooded(
  names: readonly ContenderName[],
  crowd: Crowd,
): Promise<ReadonlyMap<ContenderName, Seen[]>> {
  return withContenders(names, { ...crowd, isDurable: true }, async (entered, load) => {
    const flood = { of: "commands", inFlight: IN_FLIGHT, seconds: SECONDS } as const;
    const all = entered.flatMap(({ running }) => running.pids);
    const contenders = new Map(
      entered.map(({ name, fleet, running: { pids } }) => [
        name,
        async () => {
          await whenQuiet(all);
          return load.flood({ fleet, pids, ...flood });
        },
      ]),
    );
    // What it costs to compile the code that is used now for the first time is not what a command costs.
    await measureInTurn(contenders, FIRST_ROUNDS);
    const rounds = await measureInTurn(contenders, ROUNDS);
    const bare = rounds.get("bare") ?? [];
    for (const [name, seen] of rounds) {
      printRow(name, [
        typical(seen, rate),
        timesAsMuch(seen, bare, rate),
        typical(seen, quantileOf("answers", 0.5)),
        typical(seen, quantileOf("answers", 0.99)),
        typical(seen, costEach),
      ]);
    }
    return rounds;
  });
}
