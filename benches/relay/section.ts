/** A part of `npm run bench:relay`: measures something of the relay, prints what it saw, and judges it. */
import { formatNumber, type Goal } from "../core/goals.ts";
import type { ContenderName, Running } from "./contenders/contender.ts";
import { start } from "./contenders/start.ts";
import { Load } from "./load/load.ts";

export interface Section {
  title: string;
  measure: () => Promise<readonly Goal[]>;
}

/** A contender with its robots, connected. */
export interface Entered {
  name: ContenderName;
  running: Running;
  fleet: number;
}

export interface Crowd {
  robots: number;
  /** of so many the reader may command */
  scripts: number;
  /** pages do not end what they have begun; default: they do */
  isBusy?: boolean;
}

/** Starts what is there of these, connects robots to each, and ends all of it afterwards. */
export async function withContenders<T>(
  names: readonly ContenderName[],
  crowd: Crowd & { isDurable: boolean },
  measure: (entered: readonly Entered[], load: Load) => Promise<T>,
): Promise<T> {
  const { isDurable, ...count } = crowd;
  const load = Load.start();
  const entered: Entered[] = [];
  try {
    for (const name of names) {
      const running = await start(name, isDurable);
      if (running === null) continue;
      const { pages, readers } = running;
      const fleet = await load.open({ contender: name, pages, readers, ...count });
      entered.push({ name, running, fleet });
    }
    return await measure(entered, load);
  } finally {
    await load.stop();
    for (const { running } of entered) await running.stop();
  }
}

/** Prints a table row: a name and its cells; numbers have 3 significant digits. */
export function printRow(name: string, cells: readonly (number | string)[]): void {
  const texts = cells.map((cell) => (typeof cell === "number" ? formatNumber(cell) : cell));
  console.log(`  ${name.padEnd(24)}${texts.map((text) => text.padStart(14)).join("")}`);
}
