/** Requirements for every store, for any database. */
import { commandCases } from "./command.cases.ts";
import { keyCases } from "./key.cases.ts";
import { mazeCases } from "./maze.cases.ts";
import { pageCases } from "./page.cases.ts";
import { robotCases } from "./robot.cases.ts";
import { withdrawalCases } from "./withdrawal.cases.ts";
import { timeCases } from "./time.cases.ts";
import type { OpenStore } from "./robot-in-store.ts";

/** @param open creates an empty store, which exists until the test ends */
export function storeCases(name: string, open: () => Promise<OpenStore>): void {
  keyCases(name, open);
  robotCases(name, open);
  commandCases(name, open);
  timeCases(name, open);
  withdrawalCases(name, open);
  pageCases(name, open);
  mazeCases(name, open);
}
