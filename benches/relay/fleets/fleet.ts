/**
 * A fleet: many robots at one peer. Each robot has a page, which sends snapshots and executes
 * commands, and a reader. The interface is the same for all peers, so that one load can drive all
 * of them.
 */

/** Receives the events of a fleet's readers. */
export interface FleetListener {
  /** The robot's reader received a snapshot. @param n number of the snapshot */
  onSnapshot(robot: number, n: number): void;
  /** The reader's oldest unanswered command was answered. */
  onAnswer(robot: number): void;
  /** The reader's oldest pending command was started. Only the product reports this. */
  onStarted(robot: number): void;
  /** The page received the newest velocity. Only the product has velocities. */
  onVelocity(robot: number): void;
}

export interface FleetOptions {
  /** port, or comma-separated ports, over which robots are distributed */
  pages: string;
  readers: string;
  robots: number;
  /** number of robots whose reader is a script that may send commands */
  scripts: number;
  /** number of additional readers per robot, which send no commands */
  viewers: number;
  /**
   * Whether a page starts its first command and does not end it before `reset`. No effect for peers
   * whose pages only answer.
   */
  isBusy: boolean;
  /**
   * The topics to which readers subscribe as ROS clients, `/odom` first; null: native readers. Only
   * the product has both.
   */
  ros: readonly string[] | null;
  /**
   * Whether commands are velocities, by `/cmd_vel` or `drive`, and start when the page receives them.
   * Otherwise they are moves.
   */
  drives: boolean;
  listener: FleetListener;
}

export interface Fleet {
  /** Sends a snapshot from the page. @param n number of the snapshot; rises by 1 */
  sendSnapshot(robot: number, n: number): void;
  /** Sends a command from the script. */
  sendCommand(robot: number): void;
  /**
   * Resolves when the peer has processed all snapshots of a page; null if the reader receives every
   * snapshot.
   */
  whenProcessed: ((robot: number) => Promise<void>) | null;
  /** Stops a robot and clears its queue; null if the peer has no queue. */
  reset: ((robot: number) => Promise<void>) | null;
  close(): Promise<void>;
}

export type OpenFleet = (options: FleetOptions) => Promise<Fleet>;

/** Opens connections in batches: a thousand concurrent handshakes would time out. */
export async function openAll<T>(count: number, open: (at: number) => Promise<T>): Promise<T[]> {
  const opened: T[] = [];
  const BATCH_SIZE = 20;
  for (let at = 0; at < count; at += BATCH_SIZE) {
    const batch = Array.from({ length: Math.min(BATCH_SIZE, count - at) }, (_, i) => open(at + i));
    opened.push(...(await Promise.all(batch)));
  }
  return opened;
}
