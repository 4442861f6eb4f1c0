/** Every scenario of `npm run test:faults`, in the order of execution. */
import type { Scenario } from "./scenario.ts";
import { classInALesson } from "./scenarios/class-in-a-lesson.ts";
import { cleanNetwork } from "./scenarios/clean-network.ts";
import { cuts } from "./scenarios/cuts.ts";
import { filters } from "./scenarios/filters.ts";
import { fullDisk } from "./scenarios/full-disk.ts";
import { gateways } from "./scenarios/gateways.ts";
import { hiddenPage } from "./scenarios/hidden-page.ts";
import { slowReaders } from "./scenarios/slow-readers.ts";
import { hostileLinks } from "./scenarios/hostile-links.ts";
import { malformedFrames } from "./scenarios/malformed-frames.ts";
import { oneWayDelay } from "./scenarios/one-way-delay.ts";
import { openApiFuzz } from "./scenarios/openapi-fuzz.ts";
import { reloads } from "./scenarios/reloads.ts";
import { restoredWorlds } from "./scenarios/restored-worlds.ts";
import { savedEndings } from "./scenarios/saved-endings.ts";
import { staleMotion } from "./scenarios/stale-motion.ts";
import { twoRelays } from "./scenarios/two-relays.ts";
import { relayKilled } from "./scenarios/relay-killed.ts";
import { wrongCodes } from "./scenarios/wrong-codes.ts";

export const scenarios: readonly Scenario[] = [
  cleanNetwork,
  relayKilled,
  cuts,
  oneWayDelay,
  reloads,
  restoredWorlds,
  savedEndings,
  staleMotion,
  twoRelays,
  classInALesson,
  hiddenPage,
  slowReaders,
  wrongCodes,
  malformedFrames,
  gateways,
  fullDisk,
  filters,
  openApiFuzz,
  hostileLinks,
];
