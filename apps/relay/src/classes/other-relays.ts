/**
 * The other relays that serve a class: who is connected and watched there, as each relay announces
 * it, and what this relay announces to them.
 */
import type { Tile } from "@corridor/protocol";
import type { ClassMessage, ClassPresence } from "../bus/class-message.ts";
import { limits } from "../platform/limits/limits.ts";
import type { Clock } from "../platform/time/clock.ts";

const nobody: ClassPresence = { students: [], watched: [], dashboards: 0, screens: 0 };

interface OtherRelay {
  presence: ClassPresence;
  /** numbers of its students */
  connected: ReadonlySet<number>;
  announcedAt: number;
}

export interface OtherRelaysParts {
  clock: Clock;
  /** Sends a message to the other relays. */
  readonly notify: (message: ClassMessage) => void;
  /** @returns the connections at this relay */
  readonly presence: () => ClassPresence;
  /** The connections at other relays have changed. @param students who may be affected */
  readonly changed: (students: ReadonlySet<number>) => void;
}

export class OtherRelays {
  readonly #parts: OtherRelaysParts;
  readonly #relays = new Map<string, OtherRelay>();
  /** what the next messages contain */
  #isDue = false;
  #asks = false;
  readonly #tiles = new Map<number, Tile>();
  #sentAt = -Infinity;
  #cancelSending: (() => void) | null = null;
  /** null before the first announcement */
  #cancelRepetition: (() => void) | null = null;

  constructor(parts: OtherRelaysParts) {
    this.#parts = parts;
  }

  get isEmpty(): boolean {
    return this.#relays.size === 0;
  }

  /** dashboards at other relays */
  get dashboards(): number {
    return this.#sumOf(({ dashboards }) => dashboards);
  }

  get screens(): number {
    return this.#sumOf(({ screens }) => screens);
  }

  isConnected(student: number): boolean {
    return [...this.#relays.values()].some(({ connected }) => connected.has(student));
  }

  isWatched(student: number): boolean {
    return [...this.#relays.values()].some(({ presence }) => presence.watched.includes(student));
  }

  /** Handles the announcement of another relay. */
  received(presence: ClassPresence, from: string): void {
    const before = this.#relays.get(from)?.connected ?? [];
    const connected = new Set(presence.students.map(({ student }) => student));
    this.#relays.set(from, { presence, connected, announcedAt: this.#parts.clock.now() });
    const changed = new Set(connected);
    for (const student of before) if (!changed.delete(student)) changed.add(student);
    this.#parts.changed(changed);
  }

  /**
   * Announces the connections at this relay, now or soon.
   * @param asks whether to request tiles and display of the others
   */
  announce(asks = false): void {
    this.#isDue = true;
    this.#asks ||= asks;
    this.#cancelRepetition ??= this.#repeatLater();
    this.#sendSoon();
  }

  /** Sends the tile of a student to relays with a dashboard, now or soon. */
  tile(student: number, tile: Tile): void {
    if (this.dashboards === 0) return;
    this.#tiles.set(student, tile);
    this.#sendSoon();
  }

  /** Announces that this relay has no connections any more. */
  leave(): void {
    this.#cancelSending?.();
    this.#cancelRepetition?.();
    this.#parts.notify({ kind: "here", presence: nobody, asks: false });
  }

  #sumOf(numberIn: (presence: ClassPresence) => number): number {
    return [...this.#relays.values()].reduce((sum, { presence }) => sum + numberIn(presence), 0);
  }

  #sendSoon(): void {
    const { clock } = this.#parts;
    const waitMs = this.#sentAt + limits.classRelayIntervalMs - clock.now();
    if (waitMs <= 0) return this.#send();
    this.#cancelSending ??= clock.after(waitMs, () => {
      this.#cancelSending = null;
      this.#send();
    });
  }

  #send(): void {
    const { clock, notify, presence } = this.#parts;
    this.#sentAt = clock.now();
    if (this.#isDue) notify({ kind: "here", presence: presence(), asks: this.#asks });
    this.#isDue = false;
    this.#asks = false;
    if (this.#tiles.size === 0) return;
    notify({
      kind: "tiles",
      tiles: [...this.#tiles].map(([student, tile]) => ({ student, tile })),
    });
    this.#tiles.clear();
  }

  #repeatLater(): () => void {
    return this.#parts.clock.after(limits.relayHereMs, () => {
      this.#cancelRepetition = this.#repeatLater();
      this.#removeSilent();
      this.announce();
    });
  }

  #removeSilent(): void {
    const oldest = this.#parts.clock.now() - limits.relaySilenceMs;
    for (const [name, { connected, announcedAt }] of this.#relays) {
      if (announcedAt >= oldest) continue;
      this.#relays.delete(name);
      this.#parts.changed(connected);
    }
  }
}
