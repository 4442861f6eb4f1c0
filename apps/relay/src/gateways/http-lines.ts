/**
 * Lines by plain HTTPS, of pages and scripts whose network lets no WebSocket through. They say hello as
 * on a socket, and speak through the same conversations.
 */
import {
  closeReasons,
  type FetchedMessages,
  type Hello,
  type OpenedLine,
  type SentMessages,
  type TakenMessages,
} from "@corridor/protocol";
import { canBeKey, hashKey, markOf, mintKey } from "../keys.ts";
import { notAuthorised, Refusal, retryAfter } from "../problems.ts";
import type { Patience } from "../sessions/audience.ts";
import { limits } from "../sessions/limits.ts";
import { verbOfRole } from "../sessions/rights.ts";
import { Sweep } from "../sweep.ts";
import { closeWith } from "./conversation.ts";
import { closeFor, converse, introduced } from "./converse.ts";
import { HttpLine } from "./http-line.ts";
import type { GatewayOptions } from "./websocket-gateway.ts";

export class HttpLines {
  readonly #options: Omit<GatewayOptions, "entrance">;
  /** by the hash of their keys */
  readonly #lines = new Map<string, HttpLine>();
  readonly #heartbeats: Sweep<HttpLine>;

  constructor(options: Omit<GatewayOptions, "entrance">) {
    this.#options = options;
    this.#heartbeats = new Sweep({
      clock: options.clock,
      everyMs: limits.heartbeatMs,
      members: () => this.#lines.values(),
      visit: (line) => line.heartbeat(),
    });
  }

  /**
   * Opens a line.
   * @param from address of who asks, for the limit only
   * @throws Refusal when the key does not allow it, or when there are too many
   */
  async open(robot: string, hello: Hello, from: string, client: string): Promise<OpenedLine> {
    const { hub, clock, log, metrics } = this.#options;
    const grant = await hub.authorise(
      robot,
      hello.key,
      verbOfRole[hello.role],
      introduced(hello, client),
    );
    const ofAddress = [...this.#lines.values()].filter(({ address }) => address === from).length;
    if (ofAddress >= limits.socketsPerAddress) {
      throw new Refusal("too-many-readers", "Too many lines are open from this network.", {
        headers: retryAfter(5_000),
      });
    }
    const key = mintKey("line");
    const hash = hashKey(key);
    const line = new HttpLine({
      robot,
      address: from,
      clock,
      // As each message of a script on a socket; that a request waits says nothing of the script.
      onRequest: () => {
        if (hello.role !== "own") grant.session.spoke(grant.key);
      },
      onGone: () => void this.#lines.delete(hash),
    });
    try {
      line.begin(converse({ hello, grant, line, metrics, clock }));
    } catch (error) {
      line.drop();
      throw error;
    }
    this.#lines.set(hash, line);
    log.info({ role: hello.role, client, key: markOf(hello.key) }, "a line said hello");
    return { line: key };
  }

  /** @throws Refusal when there is no such line */
  require(robot: string, key: string | null): void {
    this.#find(robot, key);
  }

  /** Takes what the other side of a line sends. @throws Refusal when there is no such line */
  take(robot: string, key: string | null, { first, messages }: SentMessages): TakenMessages {
    const line = this.#find(robot, key);
    const failed = (error: unknown): void => closeFor(error, line, this.#options);
    return { taken: line.take(first, messages, failed) };
  }

  /** What the other side of a line has not got yet. @throws Refusal when there is no such line */
  async fetch(
    robot: string,
    key: string | null,
    after: number,
    patience: Patience,
  ): Promise<FetchedMessages> {
    return this.#find(robot, key).fetch(after, patience);
  }

  /** The other side leaves. */
  leave(robot: string, key: string | null): void {
    this.#find(robot, key).leave();
  }

  /** Closes every line because the relay stops. */
  close(): void {
    this.#heartbeats.close();
    for (const line of this.#lines.values()) closeWith(line, closeReasons.restart);
  }

  #find(robot: string, key: string | null): HttpLine {
    if (!canBeKey(key)) {
      throw notAuthorised(
        "Send the key of the line, which came with it, as: Authorization: Bearer KEY",
      );
    }
    const line = this.#lines.get(hashKey(key));
    if (line?.robot === robot) return line;
    throw new Refusal(
      "no-line",
      "It was silent for too long, or the relay was restarted. Open a new one.",
    );
  }
}
