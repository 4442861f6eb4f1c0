export { FixedTimestep } from "./fixed-timestep.ts";
export type { Progress } from "./motion/progress.ts";
export { ProgramRun, type Decider } from "./program-run.ts";
export { replayDigest, type Inputs } from "./replay.ts";
export { DELAY_DISTANCE, ROBOT_RADIUS, TICK_SECONDS, TICKS_PER_SECOND } from "./settings.ts";
export { Simulation } from "./simulation.ts";
