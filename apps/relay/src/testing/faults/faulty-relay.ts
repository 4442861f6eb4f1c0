/** A relay without sockets, on a real SQLite file, that can be killed at any moment and started again. */
import { decodeFrame, helloSchema, type SocketPort } from "@corridor/protocol";
import { pino } from "pino";
import type { Clock } from "../../clock.ts";
import { LocalSwitchboard } from "../../cluster/local-switchboard.ts";
import type { Line, Switchboard } from "../../cluster/switchboard.ts";
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

/** What outlives a relay: its database, and the lines to others that share it. */
export class Backing {
  readonly store: SqliteStore;
  readonly switchboard = new LocalSwitchboard();

  constructor(path: string) {
    this.store = new SqliteStore(new SqliteFile(path, { ballast: noBallast }));
  }
}

export class FaultyRelay {
  readonly store: SqliteStore;
  readonly hub: SessionHub;
  readonly #time: VirtualTime;
  readonly #lines: Line[] = [];
  #isAlive = true;

  constructor({ store, switchboard }: Backing, time: VirtualTime) {
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
    this.store = watched(store, time, () => this.#isAlive);
    const lines = { switchboard: this.#mortal(switchboard) };
    this.hub = new SessionHub(this.store, clock, pino({ level: "silent" }), lines);
  }

  get isAlive(): boolean {
    return this.#isAlive;
  }

  /** Nothing is said and done any more; what is in the file stays, and others find it gone. */
  kill(): void {
    this.#isAlive = false;
    for (const line of this.#lines) line.leave();
  }

  /** Lines on which a dead relay is deaf. What its last step has changed is told: the store does that. */
  #mortal(switchboard: Switchboard): Switchboard {
    return {
      join: async (robot, ears) => {
        const line = await switchboard.join(robot, {
          stepped: (step, isOwn) => this.#isAlive && ears.stepped(step, isOwn),
          missed: () => this.#isAlive && ears.missed(),
          heard: (news) => this.#isAlive && ears.heard(news),
        });
        this.#lines.push(line);
        return line;
      },
      close: () => switchboard.close(),
    };
  }

  /** Somebody connects. @returns what to do with each message, and with the end of the line */
  accept(robot: string, port: SocketPort) {
    let conversation: Conversation | null = null;
    let isClosed = false;
    let work: Promise<void> = Promise.resolve();
    const line: ReaderLine = {
      door: "websocket",
      flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
      send: (...texts) => {
        for (const text of texts) if (this.#isAlive) port.send(text);
      },
      pass: ({ message }) => {
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
    const greet = async (text: string): Promise<void> => {
      const hello = decodeFrame(helloSchema, text);
      if (!hello.ok) throw new Error("The client did not say hello.");
      const { role, key, since = null, sentAt } = hello.value;
      const grant = await this.hub.authorise(robot, key, verbOfRole[role]);
      if (isClosed) return;
      conversation =
        role === "own"
          ? new PageConversation(grant, line)
          : new DriverConversation({
              grant,
              line,
              since,
              sentAt,
              clock: this.hub.clock,
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
      closed: (saidGoodbye: boolean): void => {
        isClosed = true;
        if (!this.#isAlive) return;
        this.#time.touch();
        conversation?.closed(saidGoodbye);
      },
    };

    async function greetOrHear(text: string): Promise<void> {
      if (conversation === null) return greet(text);
      return hear(text);
    }
    async function hear(text: string): Promise<void> {
      await conversation?.received(Buffer.from(text));
    }
  }
}

/** The store; time stands still while it works, and a dead relay gets nothing from it. */
function watched(store: SqliteStore, time: VirtualTime, isAlive: () => boolean): SqliteStore {
  return new Proxy(store, {
    get(target, name) {
      const part: unknown = Reflect.get(target, name);
      if (typeof part !== "function") return part;
      // It works on nothing: it is answered at once.
      if (name === "hasAll") return part.bind(target) as unknown;
      return (...values: unknown[]) =>
        time.during(async () => {
          if (!isAlive()) throw new Error("the relay is dead");
          return Reflect.apply(part, target, values) as Promise<unknown>;
        });
    },
  });
}
