/** Every row of `npm run test:faults`, in the order in which they run. */
import type { Row } from "./row.ts";
import { cleanNet } from "./rows/clean-net.ts";
import { cuts } from "./rows/cuts.ts";
import { filtered } from "./rows/filters.ts";
import { fullDisk } from "./rows/full-disk.ts";
import { hiddenPage } from "./rows/hidden-page.ts";
import { slowReaders } from "./rows/slow-readers.ts";
import { hostileLinks } from "./rows/hostile-links.ts";
import { malformedFrames } from "./rows/malformed-frames.ts";
import { oneWayDelay } from "./rows/one-way-delay.ts";
import { openApiFuzz } from "./rows/openapi-fuzz.ts";
import { reloads } from "./rows/reloads.ts";
import { restoredWorlds } from "./rows/restored-worlds.ts";
import { savedEndings } from "./rows/saved-endings.ts";
import { staleMotion } from "./rows/stale-motion.ts";
import { twoRelays } from "./rows/two-relays.ts";
import { relayKilled } from "./rows/relay-killed.ts";

export const rows: readonly Row[] = [
  cleanNet,
  relayKilled,
  cuts,
  oneWayDelay,
  reloads,
  restoredWorlds,
  savedEndings,
  staleMotion,
  twoRelays,
  hiddenPage,
  slowReaders,
  malformedFrames,
  fullDisk,
  filtered,
  openApiFuzz,
  hostileLinks,
];
