/** Every row of `npm run test:faults`, in the order in which they run. */
import type { Row } from "./row.ts";
import { cleanNet } from "./rows/clean-net.ts";

export const rows: readonly Row[] = [cleanNet];
