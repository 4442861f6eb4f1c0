/** Checks that the host of a robot implements everything that scripts rely on. */
export { readAddress } from "./host.ts";
export { linesOf, passes, verdict } from "./report.ts";
export { gatewayGroups, groups, runChecks, type Result } from "./run-checks.ts";
