/** Faults in the pose. */
import { CONTROLLER, fault, type InjectedFault } from "../injected-fault.ts";

export const poseFaults: readonly InjectedFault[] = [
  fault(
    "pose-heading",
    "headings are counterclockwise",
    CONTROLLER,
    "round(pose.heading, 2) % 360",
    "round(-pose.heading, 2) % 360",
  ),
  fault(
    "pose-axes",
    "y grows upward",
    CONTROLLER,
    '"y": round(pose.y, 2)',
    '"y": -round(pose.y, 2)',
  ),
  fault(
    "pose-ending",
    "a final state has no pose",
    CONTROLLER,
    "return self._pose(), round(",
    'return {"x": 0, "y": 0, "heading": 0}, round(',
  ),
];
