/**
 * The live view of one robot: publishes its newest snapshot to the readers at this relay, and that
 * of a page at this relay also to other relays.
 */
import type { Clock } from "../platform/time/clock.ts";
import type { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import type { RobotChannel } from "./channel/robot-channel.ts";
import type { Subscribers } from "./readers/subscribers.ts";
import { RobotView } from "./robot-view.ts";

export interface LiveViewParts {
  clock: Clock;
  subscribers: Pick<Subscribers, "publishSnapshot">;
  channel: Pick<RobotChannel, "snapshot">;
}

export class LiveView {
  readonly #parts: LiveViewParts;
  readonly #view = new RobotView();

  constructor(parts: LiveViewParts) {
    this.#parts = parts;
  }

  /** The newest snapshot, with the current state; null if the robot has never reported. */
  get newest(): CarriedSnapshot | null {
    return this.#view.newest;
  }

  /** Whether the robot is neither gone nor paused. */
  get isAwake(): boolean {
    return this.#view.isAwake;
  }

  /** Whether the page reports that the run waits for its user. */
  get isRunPaused(): boolean {
    return this.#view.isRunPaused;
  }

  /** Publishes a snapshot of the page at this relay. */
  report(snapshot: CarriedSnapshot): void {
    this.#view.report(snapshot, this.#parts.clock.now());
    this.#publish();
  }

  /** Publishes a snapshot of the page at another relay to readers. */
  receive(snapshot: CarriedSnapshot): void {
    this.#view.receive(snapshot);
    this.#publishHere();
  }

  /** @param ageMs age of the robot if another page owned it before; 0 for its first page */
  pageConnected(ageMs: number): void {
    this.#view.pageConnected(this.#parts.clock.now(), ageMs);
  }

  /** The page at this relay disconnected. */
  pageLeft(): void {
    this.#view.pageLeft();
    this.#publish();
  }

  /** The page at another relay disconnected. */
  pageLeftElsewhere(): void {
    this.#view.pageLeft();
    this.#publishHere();
  }

  /** Checks whether the page at this relay is asleep. */
  checkAsleep(): void {
    if (this.#view.checkAsleep(this.#parts.clock.now())) this.#publish();
  }

  #publish(): void {
    this.#publishHere();
    if (this.newest !== null) this.#parts.channel.snapshot(this.newest);
  }

  #publishHere(): void {
    if (this.newest !== null) this.#parts.subscribers.publishSnapshot(this.newest);
  }
}
