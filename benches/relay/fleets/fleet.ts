/**
 * Many robots at one contender: each has a page, which reports snapshots and does commands, and a reader.
 * The same for all contenders, so that one load drives them all.
 */
export interface Ears {
  /** The robot's reader got the page's snapshot of this number, or one of the relay's numbering. */
  snapshot(robot: number, n: number): void;
  /** The reader's oldest unanswered command was answered. */
  answered(robot: number): void;
  /** The reader was told that its oldest command that had not begun has begun. Contenders that tell no such thing never say so. */
  began(robot: number): void;
}

export interface FleetOptions {
  /** port; or several, among which robots take turns */
  pages: string;
  readers: string;
  robots: number;
  /** of so many robots the reader is a script that may command; the others' only look on */
  scripts: number;
  /** more readers of each robot, which only look on */
  onlookers: number;
  /** a page begins its first command and does not end it before `rest`; of no effect where pages only answer */
  isBusy: boolean;
  ears: Ears;
}

export interface Fleet {
  /** The page reports. Numbers rise, by one each. */
  report(robot: number, n: number): void;
  /** The script commands. */
  command(robot: number): void;
  /** Once the contender has taken all that this page has reported; null: its reader gets each, and that tells. */
  taken: ((robot: number) => Promise<void>) | null;
  /** Stops a robot, so that nothing of it runs or waits; null: nothing ever does. */
  rest: ((robot: number) => Promise<void>) | null;
  close(): Promise<void>;
}

export type OpenFleet = (options: FleetOptions) => Promise<Fleet>;

/** Opens some at a time: a thousand at once would wait for each other and count as lost. */
export async function openAll<T>(count: number, open: (at: number) => Promise<T>): Promise<T[]> {
  const opened: T[] = [];
  const AT_ONCE = 20;
  for (let at = 0; at < count; at += AT_ONCE) {
    const some = Array.from({ length: Math.min(AT_ONCE, count - at) }, (_, i) => open(at + i));
    opened.push(...(await Promise.all(some)));
  }
  return opened;
}
