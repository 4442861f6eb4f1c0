/** One thing that a robot's host must do. */
import type { Host } from "./host.ts";

export interface Check {
  /** what a script may rely on, as a sentence */
  name: string;
  /** @throws Mismatch when the host does something else */
  run: (host: Host) => Promise<void>;
}

export interface CheckGroup {
  title: string;
  checks: readonly Check[];
}
