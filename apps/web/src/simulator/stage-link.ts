import type { StageLink } from "../stage/page/stage-screen.ts";
import type { SimulatorClient } from "./simulator-client.ts";

/** The simulator as the worker that draws the stage. */
export function stageLinkOf(simulator: SimulatorClient): StageLink {
  return {
    send: (message, transfer) => simulator.send(message, transfer),
    listen: (listener) =>
      simulator.listen((message) => {
        const { type } = message;
        if (type === "frame" || type === "picture" || type === "stage-scroll-to") listener(message);
      }),
  };
}
