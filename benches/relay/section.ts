/** A section of `npm run bench:relay`: measures the relay, prints tables and returns goals. */
import { formatNumber, type Goal } from "../core/goals.ts";
import { Load } from "./load/load.ts";
import type { PeerName, RunningPeer } from "./peers/peer.ts";
import { startPeer } from "./peers/start-peer.ts";

export interface Section {
  title: string;
  measure: () => Promise<readonly Goal[]>;
}

/** A running peer with its connected robots. */
export interface ConnectedPeer {
  name: PeerName;
  running: RunningPeer;
  /** number of the fleet in the load process */
  fleet: number;
}

export interface LoadSize {
  robots: number;
  /** number of robots whose reader may send commands */
  scripts: number;
  /** whether pages start commands without ending them; default: false */
  isBusy?: boolean;
}

/**
 * Starts all peers that are installed, connects robots to each, and stops all of them afterwards.
 */
export async function withPeers<T>(
  names: readonly PeerName[],
  size: LoadSize & { isDurable: boolean },
  measure: (peers: readonly ConnectedPeer[], load: Load) => Promise<T>,
): Promise<T> {
  const { isDurable, ...count } = size;
  const load = Load.start();
  const peers: ConnectedPeer[] = [];
  try {
    for (const name of names) {
      const running = await startPeer(name, isDurable);
      if (running === null) continue;
      const { pages, readers } = running;
      const fleet = await load.open({ peer: name, pages, readers, ...count });
      peers.push({ name, running, fleet });
    }
    return await measure(peers, load);
  } finally {
    await load.stop();
    for (const { running } of peers) await running.stop();
  }
}

/** Prints a table row: a name and its cells; numbers have 3 significant digits. */
export function printRow(name: string, cells: readonly (number | string)[]): void {
  const texts = cells.map((cell) => (typeof cell === "number" ? formatNumber(cell) : cell));
  console.log(`  ${name.padEnd(24)}${texts.map((text) => text.padStart(14)).join("")}`);
}
