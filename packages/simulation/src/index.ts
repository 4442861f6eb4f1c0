export { Approach, type ApproachState, type BumpCause } from "./approach.ts";
export { contactOf, type Contact } from "./contact.ts";
export { FixedTimestep } from "./fixed-timestep.ts";
export type { Progress } from "./motion/progress.ts";
export type { MotionEnding } from "./motion/motion-controller.ts";
export { ProgramRun, type Decider, type ProgramRunState } from "./program-run.ts";
export { readingsAt } from "./sensors/readings-at.ts";
export { replayDigest, type Inputs } from "./replay.ts";
export {
  DELAY_DISTANCE,
  DRIVE_STEP,
  LEAVE_DISTANCE,
  ROBOT_RADIUS,
  TICK_SECONDS,
} from "./settings.ts";
export { Simulation } from "./simulation.ts";
export type { SimulationState } from "./simulation-state.ts";
export { SnapshotDigest } from "./snapshot-digest.ts";
