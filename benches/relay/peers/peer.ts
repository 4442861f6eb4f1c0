/** The compared systems. Each forwards messages between a robot's page and its reader. */
export const peerNames = ["bare", "corridor", "socket.io", "mosquitto", "redis"] as const;
export type PeerName = (typeof peerNames)[number];

/** A peer that runs in its own process. */
export interface RunningPeer {
  /** ports for pages and readers; they differ only with two relays */
  pages: string;
  readers: string;
  /** processes whose cost is measured */
  pids: readonly number[];
  stop: () => Promise<void>;
}
