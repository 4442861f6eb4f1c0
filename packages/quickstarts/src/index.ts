export { quickstartIds, quickstarts, type Quickstart, type QuickstartId } from "./quickstarts.ts";
export type { RobotParts } from "./robot-parts.ts";
