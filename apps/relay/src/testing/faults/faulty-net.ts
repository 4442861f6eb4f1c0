/** Lines between clients and a relay that are slow and break: what is on its way then is lost. */
import type { SocketEvents, SocketPort } from "@corridor/protocol";
import type { Dice } from "./dice.ts";
import type { FaultyRelay } from "./faulty-relay.ts";
import type { VirtualTime } from "./virtual-time.ts";

/** Half of what a command may be late by: it crosses two lines. */
const SLOWEST_MS = 40;

export type Tap = (direction: "up" | "down", text: string) => void;

export class FaultyNet {
  isUp = true;
  readonly #time: VirtualTime;
  readonly #dice: Dice;
  readonly #relay: () => FaultyRelay;
  readonly #robot: string;
  readonly #tap: Tap;
  readonly #breaks = new Set<() => void>();
  #heldUntil = 0;

  /** @param tap is told of all that a client sends and gets */
  constructor(time: VirtualTime, dice: Dice, relay: () => FaultyRelay, robot: string, tap: Tap) {
    this.#time = time;
    this.#dice = dice;
    this.#relay = relay;
    this.#robot = robot;
    this.#tap = tap;
  }

  /** Breaks all lines. Each side learns of it in its own time. */
  cut(): void {
    for (const breakLine of this.#breaks) breakLine();
  }

  /** Holds up all that is sent for so long; nothing is lost. */
  holdUp(ms: number): void {
    this.#heldUntil = this.#time.now() + ms;
  }

  /** @param told is told what the relay says, in the moment in which it does */
  connect(events: SocketEvents, told: (text: string) => void = () => undefined): SocketPort {
    const time = this.#time;
    const relay = this.#relay();
    let isClientOpen = true;
    let isRelayOpen = false;
    let isBroken = false;
    const end = { client: false, relay: false };
    const up = this.#direction();
    const down = this.#direction();
    const tellClient = (code: number): void => {
      if (end.client) return;
      end.client = true;
      isClientOpen = false;
      events.closed(code);
    };
    const tellRelay = (saidGoodbye: boolean): void => {
      if (end.relay || !isRelayOpen) return;
      end.relay = true;
      isRelayOpen = false;
      gate.closed(saidGoodbye);
    };
    const breakLine = (): void => {
      if (isBroken) return;
      isBroken = true;
      this.#breaks.delete(breakLine);
      time.after(this.#dice.between(0, 150), () => tellClient(1006));
      time.after(this.#dice.between(0, 400), () => tellRelay(false));
    };
    const gate = relay.accept(this.#robot, {
      send: (text) => {
        told(text);
        down(() => {
          if (isBroken || end.client) return;
          this.#tap("down", text);
          events.received(text);
        });
      },
      close: (code) =>
        down(() => {
          if (isBroken) return;
          tellClient(code);
          tellRelay(false);
        }),
      get isOpen() {
        return isRelayOpen;
      },
      waitingBytes: 0,
    });
    if (this.isUp && relay.isAlive) {
      this.#breaks.add(breakLine);
      up(() => {
        if (isBroken || !isClientOpen) return;
        isRelayOpen = true;
        events.opened();
      });
    } else {
      isBroken = true;
      time.after(5, () => tellClient(1006));
    }
    return {
      send: (text) => {
        if (!isClientOpen) return;
        this.#tap("up", text);
        up(() => {
          if (!isBroken && isRelayOpen) gate.received(text);
        });
      },
      close: () => {
        isClientOpen = false;
        end.client = true;
        // Where it is broken, the relay finds that out by itself.
        up(() => {
          if (!isBroken) tellRelay(true);
        });
      },
      get isOpen() {
        return isClientOpen;
      },
      waitingBytes: 0,
    };
  }

  /** One direction of a line: slow, and in order. */
  #direction(): (arrive: () => void) => void {
    let latest = 0;
    return (arrive) => {
      const soon = this.#time.now() + this.#dice.between(1, SLOWEST_MS);
      const at = Math.max(latest, soon, this.#heldUntil);
      latest = at;
      this.#time.after(at - this.#time.now(), arrive);
    };
  }
}
