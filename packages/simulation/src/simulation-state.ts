/**
 * Everything that decides the next bits of a robot in a maze, as plain data: saved at the end of a tick,
 * put back later into this or another simulation of the same maze. Can be cloned by structure.
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
