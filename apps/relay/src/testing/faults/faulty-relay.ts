/** A relay without sockets, on a real SQLite file, that can be killed at any moment and started again. */
import { decodeFrame, helloSchema, type SocketPort } from "@corridor/protocol";
import { pino } from "pino";
import type { Clock } from "../../clock.ts";
import type { Conversation } from "../../gateways/conversation.ts";
import { DriverConversation } from "../../gateways/driver-conversation.ts";
import { PageConversation } from "../../gateways/page-conversation.ts";
import type { ReaderLine } from "../../gateways/reader-line.ts";
import { SessionHub } from "../../sessions/session-hub.ts";
import { verbOfRole } from "../../sessions/rights.ts";
import { SqliteFile } from "../../store/sqlite-file.ts";
import { SqliteStore } from "../../store/sqlite-store.ts";
import type { VirtualTime } from "./virtual-time.ts";

const noBallast = { hold: () => true, giveUp: () => false };

export class FaultyRelay {
  readonly store: SqliteStore;
  readonly hub: SessionHub;
  readonly #time: VirtualTime;
  #isAlive = true;

  constructor(path: string, time: VirtualTime) {
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
    this.store = watched(new SqliteStore(new SqliteFile(path, noBallast)), time);
    this.hub = new SessionHub(this.store, clock, pino({ level: "silent" }));
  }

  get isAlive(): boolean {
    return this.#isAlive;
  }

  /** Nothing is said and done any more; what is in the file stays. */
  kill(): void {
    this.#isAlive = false;
    void this.store.close();
  }

  /** Somebody connects. @returns what to do with each message, and with the end of the line */
  accept(robot: string, port: SocketPort) {
    let conversation: Conversation | null = null;
    let isClosed = false;
    let work: Promise<void> = Promise.resolve();
    const line: ReaderLine = {
      door: "websocket",
      flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
      send: (text) => {
        if (this.#isAlive) port.send(text);
      },
      close: (code, reason) => {
        if (this.#isAlive) port.close(code, reason);
      },
      get isOpen() {
        return port.isOpen;
      },
      waitingBytes: 0,
    };
    const greet = async (text: string): Promise<void> => {
      const hello = decodeFrame(helloSchema, text);
      if (!hello.ok) throw new Error("The client did not say hello.");
      const { role, key, since = null } = hello.value;
      const grant = await this.hub.authorise(robot, key, verbOfRole[role]);
      if (isClosed) return;
      conversation =
        role === "own"
          ? new PageConversation(grant, line)
          : new DriverConversation({
              grant,
              line,
              client: "Script",
              since,
              refused: () => undefined,
            });
    };
    return {
      received: (text: string): void => {
        if (!this.#isAlive) return;
        this.#time.touch();
        // Like the gateway: what a dead relay was about to do fails without a word.
        const heard = conversation === null ? work.then(() => greetOrHear(text)) : hear(text);
        work = heard.catch((error: unknown) => {
          if (this.#isAlive) throw error;
        });
      },
      closed: (): void => {
        isClosed = true;
        if (!this.#isAlive) return;
        this.#time.touch();
        conversation?.closed();
      },
    };

    async function greetOrHear(text: string): Promise<void> {
      if (conversation === null) return greet(text);
      return hear(text);
    }
    async function hear(text: string): Promise<void> {
      await conversation?.received(text);
    }
  }
}

/** The store; time stands still while it works. */
function watched(store: SqliteStore, time: VirtualTime): SqliteStore {
  return new Proxy(store, {
    get(target, name) {
      const part: unknown = Reflect.get(target, name);
      if (typeof part !== "function") return part;
      return (...values: unknown[]) =>
        time.during(async () => Reflect.apply(part, target, values) as Promise<unknown>);
    },
  });
}
