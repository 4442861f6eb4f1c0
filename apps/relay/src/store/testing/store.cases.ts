/** What every store must do, whichever database is behind it. */
import { commandCases } from "./command.cases.ts";
import { keyCases } from "./key.cases.ts";
import { mazeCases } from "./maze.cases.ts";
import { pageCases } from "./page.cases.ts";
import { sessionCases } from "./session.cases.ts";
import { takingBackCases } from "./taking-back.cases.ts";
import { timeCases } from "./time.cases.ts";
import type { OpenStore } from "./robot-in-store.ts";

/** @param open makes an empty store that goes with the test */
export function storeCases(name: string, open: () => Promise<OpenStore>): void {
  keyCases(name, open);
  sessionCases(name, open);
  commandCases(name, open);
  timeCases(name, open);
  takingBackCases(name, open);
  pageCases(name, open);
  mazeCases(name, open);
}
