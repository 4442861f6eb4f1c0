/** Replays a part of the run: the seconds before a bump, or the whole run to the goal. */
import type { SimulatorClient } from "../../simulator/simulator-client.ts";

/** @param from first tick of the replay */
export function watchAgain(simulator: Pick<SimulatorClient, "send">, from: number): void {
  simulator.send({ type: "seek", tick: Math.max(0, from) });
  simulator.send({ type: "play" });
}
