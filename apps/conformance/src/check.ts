/** One thing that a robot's host must do. */
import type { HostFeature } from "@corridor/protocol";
import type { Host } from "./host.ts";

export interface Check {
  /** id of the promise in the table of /docs/promises, "What every host promises" */
  promise: string;
  /** what a script may rely on, as a sentence */
  name: string;
  /** A host that does not offer these is not asked. */
  needs?: readonly HostFeature[];
  /** @throws Mismatch when the host does something else, NotTestable when it cannot be seen here */
  run: (host: Host) => Promise<void>;
}

export interface CheckGroup {
  title: string;
  checks: readonly Check[];
}
