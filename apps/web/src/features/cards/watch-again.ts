/** Plays a piece of the run again: the seconds before a bump, or the whole way to the goal. */
import type { SimulatorClient } from "../../worker/simulator-client.ts";

/** @param from tick to begin at */
export function watchAgain(simulator: Pick<SimulatorClient, "send">, from: number): void {
  simulator.send({ type: "seek", tick: Math.max(0, from) });
  simulator.send({ type: "play" });
}
