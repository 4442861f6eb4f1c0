/**
 * Driving by remote commands: they start in the order of their seq, a manoeuvre runs to its end, and
 * a motion without an end lasts until the next command. Only the robot ends a command that it was
 * given, and it ends each exactly once.
 */
import type { Command, EndingState, Pose } from "@corridor/protocol";
import type { Simulation } from "@corridor/simulation";
import type { CancelReason } from "./cancel-reason.ts";

export interface Delivery {
  seq: number;
  command: Command;
  /** ISO 8601, by the relay's clock */
  acceptedAt: string;
  /** the sender's idempotency key */
  key: string | null;
}

export interface Ending {
  state: EndingState;
  /** null where the robot itself ended it */
  reason: CancelReason | null;
  pose: Pose;
  /** units driven by this command */
  distance: number;
}

export interface RemoteDriverEvents {
  started(seq: number): void;
  ended(seq: number, ending: Ending): void;
}

interface Running {
  seq: number;
  distance: number;
  bumps: number;
}

export class RemoteDriver {
  readonly #events: RemoteDriverEvents;
  #waiting: Delivery[] = [];
  #running: Running | null = null;

  constructor(events: RemoteDriverEvents) {
    this.#events = events;
  }

  /** seq of the command that runs; null when none does. */
  get running(): number | null {
    return this.#running?.seq ?? null;
  }

  /** Takes a delivered command into the queue. */
  accept(delivery: Delivery): void {
    this.#waiting.push(delivery);
  }

  /** Before a tick: starts the next command unless a manoeuvre runs. */
  begin(simulation: Simulation): void {
    const next = this.#waiting[0];
    if (next === undefined || simulation.isManoeuvring) return;
    this.#waiting.shift();
    this.#end(simulation, "completed", null);
    simulation.apply(next.command);
    this.#running = { seq: next.seq, distance: simulation.distance, bumps: simulation.bumps };
    this.#events.started(next.seq);
    // Nothing to drive (stop, or a move of 0) is done at once.
    if (simulation.ending !== null || next.command.action === "stop") {
      this.#end(simulation, "completed", null);
    }
  }

  /** After a tick: ends the command whose manoeuvre is over or that ran into a wall. */
  finish(simulation: Simulation): void {
    const running = this.#running;
    if (running === null) return;
    if (simulation.ending !== null) {
      this.#end(simulation, simulation.ending, null);
    } else if (!simulation.isManoeuvring && simulation.isStopped) {
      this.#end(simulation, "collided", null);
      simulation.apply({ action: "stop" });
    }
  }

  /** Ends the running and every waiting command, and stops the robot. */
  cancel(simulation: Simulation, reason: CancelReason): void {
    this.#end(simulation, "cancelled", reason);
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const { seq } of waiting) this.#report(simulation, seq, "cancelled", reason, 0);
    simulation.apply({ action: "stop" });
  }

  #end(simulation: Simulation, state: EndingState, reason: CancelReason | null): void {
    const running = this.#running;
    if (running === null) return;
    this.#running = null;
    this.#report(simulation, running.seq, state, reason, simulation.distance - running.distance);
  }

  #report(
    simulation: Simulation,
    seq: number,
    state: EndingState,
    reason: CancelReason | null,
    distance: number,
  ): void {
    this.#events.ended(seq, { state, reason, pose: simulation.pose, distance });
  }
}
