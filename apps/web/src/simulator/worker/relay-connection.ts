/**
 * The relay connection of the run: scripts drive it, and the relay receives its snapshots. Loads
 * when Remote opens for the first time.
 */
import { RemoteDriver } from "../drivers/remote-driver.ts";
import type { CellMark } from "@corridor/protocol";
import { MarkedCells } from "../marks/marked-cells.ts";
import { RemoteHost, type RemoteHostPorts } from "./remote-host.ts";
import type { RunLoop } from "./run-loop.ts";
import { SnapshotThrottle } from "./snapshot-throttle.ts";
import type { WorldJournal } from "./world-store.ts";

export interface RelayConnectionPorts extends Pick<
  RemoteHostPorts,
  "origin" | "onView" | "save" | "restored"
> {
  run: RunLoop;
  /** monotonic milliseconds */
  now: () => number;
}

export class RelayConnection {
  readonly host: RemoteHost;
  readonly #run: RunLoop;
  readonly #throttle: SnapshotThrottle;
  readonly #marks: MarkedCells;

  constructor({ run, now, ...ports }: RelayConnectionPorts) {
    this.#run = run;
    this.#throttle = new SnapshotThrottle(now);
    this.#marks = new MarkedCells(() => run.updates.changed());
    this.host = new RemoteHost({
      ...ports,
      now: () => Date.now(),
      snapshot: () => run.snapshot(),
      onDelivery: (delivery) => run.accept(delivery),
      cancel: (reason) => run.cancelRemote(reason),
      cancelOne: (seq, reason) => run.remote?.cancelOne(seq, reason),
      reset: () => run.remote?.reset(),
      renew: (alive) => run.remote?.renew(alive),
      onMarks: (marks) => this.#marks.add(marks),
      fetch: (url, request) => fetch(url, request),
    });
    run.connect((robot) => new RemoteDriver(this.host, robot, now));
  }

  /** Endings of commands, and the running one, to be stored with the world; null without a robot. */
  get journal(): WorldJournal | null {
    const { journal } = this.host;
    return journal && { ...journal, running: this.#run.remote?.running ?? null };
  }

  /** Marks of scripts, to be drawn. */
  get marks(): readonly CellMark[] {
    return this.#marks.shown;
  }

  hideMarks(isHidden: boolean): void {
    this.#marks.hide(isHidden);
  }

  /**
   * Sends a snapshot if one is due.
   * @param hasChanged whether the run has changed since the last call
   */
  update(hasChanged: boolean): void {
    if (hasChanged) this.#throttle.changed();
    if (this.host.isOpen && this.#throttle.take()) {
      this.host.sendSnapshot(this.#run.snapshot(), this.#run.maze);
    }
  }
}
