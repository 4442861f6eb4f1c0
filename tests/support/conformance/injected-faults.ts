/** All injected faults. Each check has at least one, except those that no run can test. */
import { accessFaults } from "./faults/access.ts";
import { invalidInputFaults } from "./faults/invalid-input.ts";
import { directionsFaults } from "./faults/directions.ts";
import { eventsFaults } from "./faults/events.ts";
import { guardedMotionFaults } from "./faults/guarded-motion.ts";
import { leasesFaults } from "./faults/leases.ts";
import { lifeCycleFaults } from "./faults/life-cycle.ts";
import { limitsFaults } from "./faults/limits.ts";
import { longPollFaults } from "./faults/long-poll.ts";
import { messageFlowFaults } from "./faults/message-flow.ts";
import { poseFaults } from "./faults/pose.ts";
import { readingFaults } from "./faults/reading.ts";
import { resetFaults } from "./faults/reset.ts";
import { retriesFaults } from "./faults/retries.ts";
import { stopsFaults } from "./faults/stops.ts";
import { webSocketFaults } from "./faults/websocket.ts";
import type { InjectedFault } from "./injected-fault.ts";

export const injectedFaults: readonly InjectedFault[] = [
  ...accessFaults,
  ...directionsFaults,
  ...poseFaults,
  ...stopsFaults,
  ...retriesFaults,
  ...eventsFaults,
  ...lifeCycleFaults,
  ...readingFaults,
  ...invalidInputFaults,
  ...leasesFaults,
  ...guardedMotionFaults,
  ...resetFaults,
  ...limitsFaults,
  ...longPollFaults,
  ...webSocketFaults,
  ...messageFlowFaults,
];
