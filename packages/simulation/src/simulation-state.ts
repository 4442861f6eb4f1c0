/**
 * The complete state of a simulation as plain data, for the structured clone algorithm. It is saved
 * at the end of a tick and can be restored into any simulation of the same maze.
 */
import type { MotionState } from "./motion/motion-controller.ts";
import type { PhysicsState } from "./physics/physics-world.ts";

export interface SimulationState {
  physics: PhysicsState;
  motion: MotionState;
  heading: number;
  distance: number;
  goalTick: number | null;
  tick: number;
  isStopped: boolean;
}
