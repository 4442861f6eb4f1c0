/** The services of the robot: `/stop`, `/reset` and `/static_map`. */
import { hasEnded, type RobotPort } from "@corridor/protocol";
import type { ServiceType } from "./interface-texts.ts";
import { mapMessage } from "./map-message.ts";
import type { Message } from "./read-message.ts";
import type { RobotView } from "./robot-view.ts";
import { RosError } from "./ros-error.ts";

/** Clients wait 3 s for an answer, which also takes its time on the network and in the store. */
const WAIT_MS = 2_500;

export interface ServiceParts {
  port: RobotPort;
  view: RobotView;
}

export interface Service {
  type: ServiceType;
  /** whether it sends a command to the robot */
  isCommand?: true;
  /**
   * @param request the values of the request's definition
   * @throws RosError, or RefusedError of the port
   */
  call(request: Message, parts: ServiceParts): object | Promise<object>;
}

export const robotServices: Readonly<Record<string, Service>> = {
  "/stop": trigger("stop"),
  "/reset": trigger("reset"),
  "/static_map": {
    type: "nav_msgs/GetMap",
    call: (_request, { view }) => {
      if (view.maze === null) throw new RosError("The robot has no maze.");
      return { map: mapMessage(view.maze, view.stamp) };
    },
  },
};

/** Sends a command, and answers when it has ended. */
function trigger(action: "stop" | "reset"): Service {
  return {
    type: "std_srvs/Trigger",
    isCommand: true,
    call: async (_request, { port }) => {
      const { seq } = await port.send({ action });
      const { state, reason } = await port.endOf(seq, WAIT_MS);
      if (state === "completed") return { success: true, message: "" };
      const waiting = `The command ${action} has not ended after ${WAIT_MS / 1000} s.`;
      const ended = `The command ${action} ended as ${state}.`;
      return { success: false, message: reason ?? (hasEnded(state) ? ended : waiting) };
    },
  };
}
