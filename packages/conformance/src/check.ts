/** A requirement for the host of a robot. */
import type { HostFeature, GatewayName } from "@corridor/protocol";
import type { Host } from "./host.ts";

export interface Check {
  /** id of the promise in the tables of /docs/promises */
  promise: string;
  /** what scripts may rely on, as a sentence */
  name: string;
  /** skipped if the host does not offer one of these */
  needs?: readonly HostFeature[];
  /**
   * The check only waits for messages: it starts with its group and runs beside the other checks.
   */
  onlyListens?: boolean;
  /**
   * @throws Mismatch if the host fails the check, NotTestable if it cannot be checked here,
   * NeverTestable if no run of the kit can test it
   */
  run: (host: Host) => Promise<void>;
}

export interface CheckGroup {
  title: string;
  /** skipped if the operator of the host has switched this gateway off */
  gateway?: GatewayName;
  checks: readonly Check[];
}
