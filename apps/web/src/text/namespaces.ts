/**
 * The parts that the words come in, as English has them; `t` checks its keys against these.
 * "words" is what the page itself says. A part that only some readers need is a namespace of its own,
 * loaded in whatever language the page has when it is first used: `useTranslation("missions")`.
 */
import type { en } from "./en/index.ts";
import type diagnosis from "./en/diagnosis.json";
import type missions from "./en/missions.json";
import type otherMazes from "./en/other-mazes.json";
import type runDetails from "./en/run-details.json";
import type race from "./en/race.json";
import type daily from "./en/daily.json";
import type sound from "./en/sound.json";
import type watch from "./en/watch.json";

export interface Namespaces {
  words: typeof en;
  /** why a run failed */
  diagnosis: typeof diagnosis;
  /** the lessons */
  missions: typeof missions;
  /** "Try it in other mazes" */
  otherMazes: typeof otherMazes;
  /** what the run's controls say only once they are used: taking over, zoom, commands */
  runDetails: typeof runDetails;
  /** races against recorded runs */
  race: typeof race;
  /** the maze of the day */
  daily: typeof daily;
  /** sounds of the run */
  sound: typeof sound;
  /** the page of whoever looks on */
  watch: typeof watch;
}

export type Namespace = keyof Namespaces;
