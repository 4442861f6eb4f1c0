import type { SocketEvents } from "@corridor/protocol";
import type { Platform } from "../platform.ts";

export interface FakeSocket {
  url: string;
  /** parsed messages of the client */
  sent: Record<string, unknown>[];
  /** whether the client has closed it */
  isClosed: boolean;
  open(): void;
  receive(message: unknown): void;
  receiveText(text: string): void;
  /** The relay or the network closes it. */
  cut(code: number): void;
}

interface Timer {
  at: number;
  call(): void;
}

/** A platform with virtual time, whose sockets the test controls. */
export class FakePlatform implements Platform {
  readonly sockets: FakeSocket[] = [];
  readonly warnings: string[] = [];
  /** the value of `random` */
  luck = 0.5;
  #now = 0;
  #keys = 0;
  readonly #timers = new Set<Timer>();

  readonly clock = {
    now: (): number => this.#now,
    after: (ms: number, call: () => void) => {
      const timer = { at: this.#now + ms, call };
      this.#timers.add(timer);
      return () => void this.#timers.delete(timer);
    },
  };

  readonly warn = (text: string): void => void this.warnings.push(text);
  readonly random = (): number => this.luck;
  readonly uniqueText = (): string => `key-${String((this.#keys += 1)).padStart(6, "0")}`;

  readonly connect = (url: string, events: SocketEvents) => {
    const socket: FakeSocket = {
      url,
      sent: [],
      isClosed: false,
      open: () => events.opened(),
      receive: (message) => events.received(JSON.stringify(message)),
      receiveText: (text) => events.received(text),
      cut: (code) => events.closed(code),
    };
    this.sockets.push(socket);
    return {
      send: (text: string) => void socket.sent.push(JSON.parse(text) as Record<string, unknown>),
      close: () => void (socket.isClosed = true),
      get isOpen() {
        return !socket.isClosed;
      },
      waitingBytes: 0,
    };
  };

  /** The newest socket. */
  get socket(): FakeSocket {
    const socket = this.sockets.at(-1);
    if (socket === undefined) throw new Error("No socket was opened yet.");
    return socket;
  }

  /** Advances the time by `ms`, and runs due timers in order. */
  pass(ms: number): void {
    const end = this.#now + ms;
    for (;;) {
      const due = [...this.#timers]
        .filter(({ at }) => at <= end)
        .toSorted((a, b) => a.at - b.at)[0];
      if (due === undefined) break;
      this.#timers.delete(due);
      this.#now = due.at;
      due.call();
    }
    this.#now = end;
  }
}
