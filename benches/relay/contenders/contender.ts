/** What is measured side by side: something that passes messages between a robot's page and its reader. */
export const contenderNames = ["bare", "corridor", "socket.io", "mosquitto", "redis"] as const;
export type ContenderName = (typeof contenderNames)[number];

/** One that runs, in a process of its own. */
export interface Running {
  /** where pages connect, and where readers do: the same unless there are two relays */
  pages: string;
  readers: string;
  /** processes whose cost counts */
  pids: readonly number[];
  stop: () => Promise<void>;
}
