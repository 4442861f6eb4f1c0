/** The open sockets of a gateway: how many each address has, and which of them still answer. */
import { closeReasons } from "@corridor/protocol";
import type { WebSocket } from "ws";
import { limits } from "../../platform/limits/limits.ts";
import type { Clock } from "../../platform/time/clock.ts";
import { StaggeredInterval } from "../../platform/time/staggered-interval.ts";
import { closeWith } from "../conversations/conversation.ts";

export interface OpenSocket {
  readonly socket: WebSocket;
  /** time of its last message or pong */
  lastMessageAt: number;
  lastHeartbeatAt: number;
}

export interface OpenSocketsOptions<S extends OpenSocket> {
  clock: Clock;
  /** Called for each open socket at regular times. */
  heartbeat?: (open: S) => void;
}

export class OpenSockets<S extends OpenSocket> {
  readonly #options: OpenSocketsOptions<S>;
  readonly #all = new Set<S>();
  readonly #countByAddress = new Map<string, number>();
  readonly #checks: StaggeredInterval<S>;

  constructor(options: OpenSocketsOptions<S>) {
    this.#options = options;
    this.#checks = new StaggeredInterval({
      clock: options.clock,
      everyMs: limits.silenceCheckMs,
      members: () => this.#all,
      visit: (open) => this.#check(open),
    });
  }

  countOf(address: string): number {
    return this.#countByAddress.get(address) ?? 0;
  }

  add(open: S, address: string): void {
    this.#all.add(open);
    this.#countByAddress.set(address, this.countOf(address) + 1);
  }

  /** Removes a closed socket. */
  remove(open: S, address: string): void {
    this.#all.delete(open);
    const others = this.countOf(address) - 1;
    if (others > 0) this.#countByAddress.set(address, others);
    else this.#countByAddress.delete(address);
  }

  /** Closes all sockets because the relay shuts down. */
  close(): void {
    this.#checks.close();
    for (const { socket } of this.#all) closeWith(socket, closeReasons.restart);
  }

  /** Destroys the sockets that did not answer the close frame. */
  destroyAll(): void {
    for (const { socket } of this.#all) socket.terminate();
  }

  /** Pings a silent client, and destroys its socket if no answer arrives. */
  #check(open: S): void {
    const { clock, heartbeat } = this.#options;
    const now = clock.now();
    const silentMs = now - open.lastMessageAt;
    if (silentMs >= limits.silenceMs) return open.socket.terminate();
    // Half a check interval early rather than late, because checks are off by some ms.
    const isDue = now - open.lastHeartbeatAt >= limits.heartbeatMs - limits.silenceCheckMs / 2;
    if (!isDue || open.socket.readyState !== open.socket.OPEN) return;
    open.lastHeartbeatAt = now;
    // An active client needs no ping. The pong to the previous ping arrived a while after it.
    if (silentMs >= limits.heartbeatMs / 2) open.socket.ping();
    heartbeat?.(open);
  }
}
