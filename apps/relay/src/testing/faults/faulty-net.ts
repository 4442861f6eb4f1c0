/**
 * Slow and unreliable connections between clients and a relay. Messages in transit are lost when a
 * connection breaks.
 */
import type { SocketEvents, SocketPort } from "@corridor/protocol";
import type { SeededRandom } from "./seeded-random.ts";
import type { FaultyRelay } from "./faulty-relay.ts";
import type { VirtualTime } from "./virtual-time.ts";

/** Half of the tolerated lateness of a command, which crosses two connections. */
const MAX_DELAY_MS = 40;

export type Tap = (direction: "up" | "down", text: string) => void;

export class FaultyNet {
  isUp = true;
  readonly #time: VirtualTime;
  readonly #random: SeededRandom;
  readonly #relay: () => FaultyRelay;
  readonly #robot: string;
  readonly #tap: Tap;
  readonly #breaks = new Set<() => void>();
  #heldUntil = 0;

  /** @param tap receives all that a client sends and receives */
  constructor(
    time: VirtualTime,
    random: SeededRandom,
    relay: () => FaultyRelay,
    robot: string,
    tap: Tap,
  ) {
    this.#time = time;
    this.#random = random;
    this.#relay = relay;
    this.#robot = robot;
    this.#tap = tap;
  }

  /** Breaks all connections. Each side detects it after its own delay. */
  cut(): void {
    for (const breakConnection of this.#breaks) breakConnection();
  }

  /** Delays all messages for `ms` without loss. */
  holdUp(ms: number): void {
    this.#heldUntil = this.#time.now() + ms;
  }

  /** @param onSent receives each message of the relay when it is sent */
  connect(events: SocketEvents, onSent: (text: string) => void = () => undefined): SocketPort {
    const time = this.#time;
    const relay = this.#relay();
    let isClientOpen = true;
    let isRelayOpen = false;
    let isBroken = false;
    const end = { client: false, relay: false };
    const up = this.#direction();
    const down = this.#direction();
    const closeClient = (code: number): void => {
      if (end.client) return;
      end.client = true;
      isClientOpen = false;
      events.closed(code);
    };
    const closeRelay = (isClosedByClient: boolean): void => {
      if (end.relay || !isRelayOpen) return;
      end.relay = true;
      isRelayOpen = false;
      relaySide.closed(isClosedByClient);
    };
    const breakConnection = (): void => {
      if (isBroken) return;
      isBroken = true;
      this.#breaks.delete(breakConnection);
      time.after(this.#random.between(0, 150), () => closeClient(1006));
      time.after(this.#random.between(0, 400), () => closeRelay(false));
    };
    const relaySide = relay.accept(this.#robot, {
      send: (text) => {
        onSent(text);
        down(() => {
          if (isBroken || end.client) return;
          this.#tap("down", text);
          events.received(text);
        });
      },
      close: (code) =>
        down(() => {
          if (isBroken) return;
          closeClient(code);
          closeRelay(false);
        }),
      get isOpen() {
        return isRelayOpen;
      },
      waitingBytes: 0,
    });
    if (this.isUp && relay.isAlive) {
      this.#breaks.add(breakConnection);
      up(() => {
        if (isBroken || !isClientOpen) return;
        isRelayOpen = true;
        events.opened();
      });
    } else {
      isBroken = true;
      time.after(5, () => closeClient(1006));
    }
    return {
      send: (text) => {
        if (!isClientOpen) return;
        this.#tap("up", text);
        up(() => {
          if (!isBroken && isRelayOpen) relaySide.received(text);
        });
      },
      close: () => {
        isClientOpen = false;
        end.client = true;
        // If the connection is broken, the relay detects that itself.
        up(() => {
          if (!isBroken) closeRelay(true);
        });
      },
      get isOpen() {
        return isClientOpen;
      },
      waitingBytes: 0,
    };
  }

  /** One direction of a connection: delayed, in order. */
  #direction(): (arrive: () => void) => void {
    let latest = 0;
    return (arrive) => {
      const soon = this.#time.now() + this.#random.between(1, MAX_DELAY_MS);
      const at = Math.max(latest, soon, this.#heldUntil);
      latest = at;
      this.#time.after(at - this.#time.now(), arrive);
    };
  }
}
