/** An example follows the right wall over a network that delays, slices and cuts connections. */
import { countOpenCells, generateTree } from "@corridor/maze";
import { snapshotSchema } from "@corridor/protocol";
import type { FaultProxy } from "../../../e2e/faults/net/fault-proxy.ts";
import { exampleCommand, runScript, type ExampleLanguage } from "../../../e2e/support/script.ts";
import { recordsAfter } from "./command-records.ts";

export const followedMaze = generateTree({ columns: 7, rows: 7, seed: 3, name: "Tree" });
const cells = `${countOpenCells(followedMaze)}`;
const DELAY_MS = { min: 0, max: 30 };
/** shorter than many exchanges take under this delay, longer than a reconnection takes */
const CUT_EVERY_MS = 450;

/**
 * Runs a wall follower until it has visited every cell.
 * @param address of a robot in the maze, through the network
 * @returns its exit code, whether it visited every cell, the robot's commands and bumps, and the
 * number of lost connections
 */
export async function followWall(
  language: ExampleLanguage,
  address: string,
  { network, isBad }: { network: FaultProxy; isBad: boolean },
) {
  let cut = 0;
  const cuts = setInterval(() => (cut += isBad ? network.cut() : 0), CUT_EVERY_MS);
  if (isBad) {
    network.delay = DELAY_MS;
    network.isSlicing = true;
  }
  const { code, output } = await runScript([
    ...exampleCommand(language),
    address,
    "--until-cells",
    cells,
  ]);
  clearInterval(cuts);
  network.clearFaults();
  const { origin, pathname, hash } = new URL(address);
  const answer = await fetch(`${origin}/api/v1/robots/${pathname.slice("/r/".length)}/sensors`, {
    headers: { authorization: `Bearer ${hash.slice(1)}` },
  });
  const { bumps } = snapshotSchema.parse(await answer.json());
  const records = await recordsAfter(address, 0);
  const commands = records.map(({ action, state, pose }) => ({ action, state, pose }));
  const hasVisitedAll = output.includes(`${cells} cells visited`);
  return { code, output, hasVisitedAll, commands, bumps, cut };
}
