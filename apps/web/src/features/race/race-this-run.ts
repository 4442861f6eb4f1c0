/** Makes the run on the screen a ghost. Loads with the first press. */
import type { i18n } from "i18next";
import { raceService, type RacePorts } from "./race-service.ts";

export async function raceThisRun(
  ports: RacePorts,
  words: Pick<i18n, "t" | "loadNamespaces">,
): Promise<void> {
  await words.loadNamespaces("race");
  await raceService(ports, words).raceThisRun();
}
