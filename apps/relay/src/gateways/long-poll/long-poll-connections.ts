/**
 * Long-poll connections over HTTPS, for pages and scripts whose network blocks WebSockets. They use
 * the same hello and the same conversations as sockets.
 */
import { closeReasons, type Hello, type OpenedConnection } from "@corridor/protocol";
import { canBeKey, hashKey, markOf, mintKey } from "../../platform/keys.ts";
import { notAuthorised, Refusal, retryAfter } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { verbOfRole } from "../../robots/access/caller.ts";
import { StaggeredInterval } from "../../platform/time/staggered-interval.ts";
import { closeWith } from "../conversations/conversation.ts";
import {
  closeOnError,
  startConversation,
  introductionOf,
} from "../conversations/start-conversation.ts";
import { LongPollConnection, noConnection } from "./long-poll-connection.ts";
import type { GatewayOptions } from "../websocket/websocket-gateway.ts";

export class LongPollConnections {
  readonly #options: Omit<GatewayOptions, "guard">;
  /** by the hash of their keys */
  readonly #connections = new Map<string, LongPollConnection>();
  readonly #heartbeats: StaggeredInterval<LongPollConnection>;

  constructor(options: Omit<GatewayOptions, "guard">) {
    this.#options = options;
    this.#heartbeats = new StaggeredInterval({
      clock: options.clock,
      everyMs: limits.heartbeatMs,
      members: () => this.#connections.values(),
      visit: (connection) => connection.heartbeat(),
    });
  }

  /**
   * Opens a connection.
   * @param from client address, for the limit only
   * @throws Refusal if the key does not permit it, or if there are too many connections
   */
  async open(robot: string, hello: Hello, from: string, client: string): Promise<OpenedConnection> {
    const { registry, clock, log, metrics } = this.#options;
    const grant = await registry.authorise(
      robot,
      hello.key,
      verbOfRole[hello.role],
      introductionOf(hello, client),
    );
    const fromAddress = [...this.#connections.values()].filter(
      ({ address }) => address === from,
    ).length;
    if (fromAddress >= limits.socketsPerAddress) {
      throw new Refusal(
        "too-many-readers",
        "Too many long-poll connections are open from this network. Close one, then try again.",
        {
          headers: retryAfter(5_000),
        },
      );
    }
    const key = mintKey("connection");
    const hash = hashKey(key);
    const connection: LongPollConnection = new LongPollConnection({
      robot,
      address: from,
      clock,
      // Counts as activity of a script, like a message on a socket. A waiting request does not
      // count.
      onRequest: () => {
        if (hello.role !== "own") grant.robot.spoke(grant.key);
      },
      onEnded: () => void this.#connections.delete(hash),
      onError: (error) => closeOnError(error, connection, this.#options),
    });
    try {
      connection.start(startConversation({ hello, grant, connection, metrics, clock }));
    } catch (error) {
      connection.drop();
      throw error;
    }
    this.#connections.set(hash, connection);
    log.info(
      { role: hello.role, client, key: markOf(hello.key) },
      "long-poll client authenticated",
    );
    return { key };
  }

  /**
   * The connection with this key.
   * @throws Refusal not-authorised, or no-connection if the robot has no connection with this key
   */
  find(robot: string, key: string | null): LongPollConnection {
    if (!canBeKey(key)) {
      throw notAuthorised(
        "Send the key of the long-poll connection, from the response to POST /long-poll, as: Authorization: Bearer KEY",
      );
    }
    const connection = this.#connections.get(hashKey(key));
    if (connection?.robot === robot) return connection;
    throw noConnection();
  }

  /** Closes all connections because the relay shuts down. */
  close(): void {
    this.#heartbeats.close();
    for (const connection of this.#connections.values())
      closeWith(connection, closeReasons.restart);
  }
}
