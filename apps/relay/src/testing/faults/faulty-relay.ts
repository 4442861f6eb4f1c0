/** A relay without sockets, on a real SQLite file, that can be killed and restarted at any time. */
import { decodeFrame, helloSchema, type SocketPort } from "@corridor/protocol";
import { pino } from "pino";
import type { Clock } from "../../platform/time/clock.ts";
import { LocalBus } from "../../bus/local.ts";
import type { Channel, Bus } from "../../bus/bus.ts";
import type { Conversation, ClientConnection } from "../../gateways/conversations/conversation.ts";
import { DriverConversation } from "../../gateways/conversations/driver-conversation.ts";
import { PageConversation } from "../../gateways/conversations/page-conversation.ts";
import { RobotRegistry } from "../../robots/registry.ts";
import { verbOfRole } from "../../robots/access/callers.ts";
import { SqliteFile } from "../../store/sqlite/file/sqlite-file.ts";
import { SqliteRobotStore } from "../../store/sqlite/sqlite-robot-store.ts";
import type { VirtualTime } from "./virtual-time.ts";

const noBallast = { hold: () => true, release: () => false };

/** What survives a relay: its database, and the message bus to other relays. */
export class Backend {
  readonly store: SqliteRobotStore;
  readonly bus = new LocalBus();

  constructor(path: string) {
    this.store = new SqliteRobotStore(new SqliteFile(path, { ballast: noBallast }));
  }
}

export class FaultyRelay {
  readonly store: SqliteRobotStore;
  readonly registry: RobotRegistry;
  readonly #time: VirtualTime;
  readonly #channels: Channel[] = [];
  #isAlive = true;

  constructor({ store, bus }: Backend, time: VirtualTime) {
    this.#time = time;
    const clock: Clock = {
      now: () => time.now(),
      after: (ms, call) =>
        time.after(ms, () => {
          if (!this.#isAlive) return;
          time.touch();
          call();
        }),
    };
    this.store = withVirtualTime(store, time, () => this.#isAlive);
    const lines = { bus: this.#whileAlive(bus) };
    this.registry = new RobotRegistry(this.store, clock, pino({ level: "silent" }), lines);
  }

  get isAlive(): boolean {
    return this.#isAlive;
  }

  /** Stops all activity. The file remains, and other relays see it disconnect. */
  kill(): void {
    this.#isAlive = false;
    for (const channel of this.#channels) channel.leave();
  }

  /**
   * A message bus that delivers nothing to a dead relay. The changes of its last step are still
   * published, because the store publishes them.
   */
  #whileAlive(bus: Bus): Bus {
    return {
      join: async (robot, listener) => {
        const channel = await bus.join(robot, {
          commandsChanged: (changes, isOwn) =>
            this.#isAlive && listener.commandsChanged(changes, isOwn),
          missed: () => this.#isAlive && listener.missed(),
          received: (message) => this.#isAlive && listener.received(message),
        });
        this.#channels.push(channel);
        return channel;
      },
      close: () => bus.close(),
    };
  }

  /** Accepts a connection. @returns handlers for its messages and its end */
  accept(robot: string, port: SocketPort) {
    let conversation: Conversation | null = null;
    let isClosed = false;
    let work: Promise<void> = Promise.resolve();
    const connection: ClientConnection = {
      transport: "websocket",
      flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
      send: (...texts) => {
        for (const text of texts) if (this.#isAlive) port.send(text);
      },
      sendSnapshot: ({ message }) => {
        if (this.#isAlive) port.send(message.toString());
      },
      close: (code, reason) => {
        if (this.#isAlive) port.close(code, reason);
      },
      get isOpen() {
        return port.isOpen;
      },
      waitingBytes: 0,
    };
    const authenticate = async (text: string): Promise<void> => {
      const hello = decodeFrame(helloSchema, text);
      if (!hello.ok) throw new Error("The first message of the client is not a hello.");
      const { role, key, since = null, sentAt } = hello.value;
      const grant = await this.registry.authorise(robot, key, verbOfRole[role]);
      if (isClosed) return;
      conversation =
        role === "own"
          ? new PageConversation(grant, connection)
          : new DriverConversation({
              grant,
              connection,
              since,
              sentAt,
              clock: this.registry.clock,
              onRefusal: () => undefined,
            });
    };
    return {
      received: (text: string): void => {
        if (!this.#isAlive) return;
        this.#time.touch();
        // As in the gateway, pending work of a dead relay fails silently.
        const handled =
          conversation === null ? work.then(() => authenticateOrReceive(text)) : receive(text);
        work = handled.catch((error: unknown) => {
          if (this.#isAlive) throw error;
        });
      },
      closed: (isClosedByClient: boolean): void => {
        isClosed = true;
        if (!this.#isAlive) return;
        this.#time.touch();
        conversation?.closed(isClosedByClient);
      },
    };

    async function authenticateOrReceive(text: string): Promise<void> {
      if (conversation === null) return authenticate(text);
      return receive(text);
    }
    async function receive(text: string): Promise<void> {
      await conversation?.received(Buffer.from(text));
    }
  }
}

/** The store. Virtual time stands still during its steps, and a dead relay gets no results. */
function withVirtualTime(
  store: SqliteRobotStore,
  time: VirtualTime,
  isAlive: () => boolean,
): SqliteRobotStore {
  return new Proxy(store, {
    get(target, name) {
      const part: unknown = Reflect.get(target, name);
      if (typeof part !== "function") return part;
      // Synchronous, so it needs no waiting.
      if (name === "current") return part.bind(target) as unknown;
      return (...values: unknown[]) =>
        time.during(async () => {
          if (!isAlive()) throw new Error("the relay is dead");
          return Reflect.apply(part, target, values) as Promise<unknown>;
        });
    },
  });
}
