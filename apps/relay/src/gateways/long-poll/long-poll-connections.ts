/**
 * Long-poll connections over HTTPS, for clients whose network blocks WebSockets. They use
 * the same hello and the same conversations as sockets.
 */
import { closeReasons, type OpenedConnection } from "@corridor/protocol";
import { canBeKey, hashKey, markOf, mintKey } from "../../platform/keys.ts";
import { notAuthorised, Refusal, retryAfter } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { StaggeredInterval } from "../../platform/time/staggered-interval.ts";
import { closeWith } from "../conversations/conversation.ts";
import { closeOnError } from "../conversations/close-on-error.ts";
import { LongPollConnection, noConnection } from "./long-poll-connection.ts";
import type { GatewayOptions } from "../websocket/websocket-gateway.ts";

export class LongPollConnections<H extends { role: string; key: string }> {
  readonly #options: Omit<GatewayOptions<H>, "guard">;
  /** by the hash of their keys */
  readonly #connections = new Map<string, LongPollConnection>();
  readonly #heartbeats: StaggeredInterval<LongPollConnection>;

  constructor(options: Omit<GatewayOptions<H>, "guard">) {
    this.#options = options;
    this.#heartbeats = new StaggeredInterval({
      clock: options.clock,
      everyMs: limits.heartbeatMs,
      members: () => this.#connections.values(),
      visit: (connection) => connection.heartbeat(),
    });
  }

  get endpoint(): GatewayOptions<H>["endpoint"] {
    return this.#options.endpoint;
  }

  /**
   * Opens a connection.
   * @param from client address, for the limit only
   * @throws Refusal if the key does not permit it, or if there are too many connections
   */
  async open(id: string, hello: H, from: string, client: string): Promise<OpenedConnection> {
    const { endpoint, clock, log } = this.#options;
    const admitted = await endpoint.admit(id, hello, client);
    const fromAddress = [...this.#connections.values()].filter(
      ({ address }) => address === from,
    ).length;
    if (fromAddress >= endpoint.connectionsPerAddress) {
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
      id,
      address: from,
      clock,
      // A waiting request does not count.
      onRequest: () => admitted.requested(),
      onEnded: () => void this.#connections.delete(hash),
      onError: (error) => closeOnError(error, connection, this.#options),
    });
    try {
      connection.start(admitted.start(connection));
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
   * @throws Refusal not-authorised, or no-connection if there is none with this key at the id
   */
  find(id: string, key: string | null): LongPollConnection {
    if (!canBeKey(key)) {
      throw notAuthorised(
        "Send the key of the long-poll connection, from the response to POST /long-poll, as: Authorization: Bearer KEY",
      );
    }
    const connection = this.#connections.get(hashKey(key));
    if (connection?.id === id) return connection;
    throw noConnection();
  }

  /** Closes all connections because the relay shuts down. */
  close(): void {
    this.#heartbeats.close();
    for (const connection of this.#connections.values())
      closeWith(connection, closeReasons.restart);
  }
}
