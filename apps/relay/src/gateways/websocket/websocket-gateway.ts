/**
 * WebSockets of one endpoint, robots or classes: admission, authentication and liveness.
 *
 * A client must first send one message of at most 1 KiB with a key, within 5 seconds. After that, a
 * conversation handles its messages.
 */
import type { IncomingMessage } from "node:http";
import type { Duplex } from "node:stream";
import { closeReasons, decodeFrame, describeProblem, MAX_HELLO_BYTES } from "@corridor/protocol";
import type { Logger } from "pino";
import { WebSocketServer, type WebSocket } from "ws";
import { clientName } from "../../platform/http/client-name.ts";
import type { Clock } from "../../platform/time/clock.ts";
import { markOf } from "../../platform/keys.ts";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import { asRefusal, Refusal } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import {
  closeWith,
  handleMessage,
  type Conversation,
  type ClientConnection,
} from "../conversations/conversation.ts";
import { closeOnError } from "../conversations/close-on-error.ts";
import type { Endpoint } from "../conversations/endpoint.ts";
import type { GatewayMetrics } from "../conversations/start-conversation.ts";
import { UnauthenticatedMessages } from "../conversations/unauthenticated-messages.ts";
import { refuseUpgrade } from "../../platform/http/refuse-upgrade.ts";
import { OpenSockets, type OpenSocket } from "./open-sockets.ts";
import { SocketWithReasons } from "./socket-with-reasons.ts";
import { WsPort } from "./ws-port.ts";

const nothing = (): void => undefined;

/**
 * Close codes with which clients close on their own: 1001 is a closed or reloaded tab, 1005 has no
 * code. With a code of the relay the client only confirms, and its last messages were not received.
 */
const clientCloseCodes: ReadonlySet<number> = new Set([1000, 1001, 1005]);

const PATH = /^\/api\/v1\/(robots|classes)\/([^/]{1,64})\/socket$/;

interface Client extends OpenSocket {
  port: ClientConnection;
  /** id in the address */
  id: string;
  /** the script's language, such as "Python" */
  language: string;
  /** cancels the timeout for its first message */
  cancelTimer: () => void;
  /** id of its key for logs */
  key: string | null;
  conversation: Conversation | null;
}

export interface GatewayOptions<H extends { role: string; key: string }> {
  endpoint: Endpoint<H>;
  clock: Clock;
  log: Logger;
  guard: RequestGuard;
  metrics: GatewayMetrics;
}

export class WebSocketGateway<H extends { role: string; key: string }> {
  readonly #options: GatewayOptions<H>;
  readonly #server: WebSocketServer;
  readonly #clients: OpenSockets<Client>;

  constructor(options: GatewayOptions<H>) {
    this.#options = options;
    this.#server = new WebSocketServer({
      noServer: true,
      maxPayload: options.endpoint.maxMessageBytes,
      perMessageDeflate: false,
      clientTracking: false,
      WebSocket: SocketWithReasons,
    });
    this.#clients = new OpenSockets({
      clock: options.clock,
      heartbeat: ({ conversation }) => conversation?.heartbeat(),
    });
  }

  /** Whether a request is for a socket of this endpoint. */
  isFor({ url }: IncomingMessage): boolean {
    return PATH.exec(pathIn(url))?.[1] === this.#options.endpoint.name;
  }

  /** Handles an upgrade request of the HTTP server. An invalid one receives a problem document. */
  upgrade(request: IncomingMessage, socket: Duplex, head: Buffer): void {
    let id: string;
    try {
      id = this.#admit(request);
    } catch (error) {
      const refusal = asRefusal(error);
      this.#options.metrics.refused(refusal.kind);
      return refuseUpgrade(socket, refusal);
    }
    this.#server.handleUpgrade(request, socket, head, (webSocket) => {
      this.#accept(webSocket, socket, { request, id });
    });
  }

  /** Closes all sockets because the relay shuts down. */
  close(): void {
    this.#clients.close();
    this.#server.close();
  }

  /** Destroys the sockets that did not answer the close frame. */
  destroyAll(): void {
    this.#clients.destroyAll();
  }

  /** @returns the id in the address @throws Refusal if no socket may be opened there */
  #admit(request: IncomingMessage): string {
    const { guard } = this.#options;
    guard.checkHost(request);
    const id = PATH.exec(pathIn(request.url))?.[2];
    if (id === undefined) {
      throw new Refusal(
        "not-found",
        "There is no WebSocket at this path. Connect to /api/v1/robots/ID/socket.",
      );
    }
    if (!guard.isOwnPage(request)) {
      throw new Refusal(
        "forbidden",
        "Pages of other sites cannot open this socket. Use the HTTP API.",
      );
    }
    return id;
  }

  /** Does not retain the request, which is larger than all other state of an idle client. */
  #accept(
    socket: WebSocket,
    connection: Duplex,
    { request, id }: { request: IncomingMessage; id: string },
  ): void {
    const { clock, guard, metrics } = this.#options;
    const address = guard.addressOf(request);
    const client: Client = {
      socket,
      port: new WsPort(socket, connection, clock),
      id,
      language: clientName(request.headers["user-agent"]),
      cancelTimer: clock.after(limits.helloMs, () => {
        const { reason, detail } = this.#options.endpoint.unauthorised;
        if (client.conversation === null) closeWith(socket, reason, detail);
      }),
      lastMessageAt: clock.now(),
      lastHeartbeatAt: clock.now(),
      key: null,
      conversation: null,
    };
    this.#clients.add(client, address);
    // Messages are processed in order, so that none overtakes the first.
    let work: Promise<void> = Promise.resolve();
    const waiting = new UnauthenticatedMessages();
    const receive = (data: Buffer, isBinary: boolean): void => {
      // Messages still arrive while a socket closes, but responses could not be sent.
      if (!client.port.isOpen) return;
      client.lastMessageAt = clock.now();
      if (isBinary)
        return closeWith(
          socket,
          closeReasons.badFrame,
          "Binary messages are not supported. Send JSON text.",
        );
      if (client.conversation !== null) return this.#handle(client, data);
      if (!waiting.accepts(data.length))
        return closeWith(
          socket,
          closeReasons.notAuthorised,
          "Too many messages before the key was checked. Wait for the response.",
        );
      work = work
        .then(() => this.#hello(client, data))
        .catch((error: unknown) => this.#refuse(client, error));
    };
    socket.on("message", receive);
    socket.on("pong", () => (client.lastMessageAt = clock.now()));
    // On oversized messages or broken framing, `ws` closes the socket with 1009 or 1002.
    socket.on("error", (error) => this.#options.log.debug({ err: error }, "WebSocket error"));
    socket.on("close", (code) => {
      metrics.socketClosed(code);
      this.#options.log.info({ code, key: client.key }, "WebSocket closed");
      client.cancelTimer();
      this.#clients.remove(client, address);
      client.conversation?.closed(clientCloseCodes.has(code));
    });
    if (this.#clients.countOf(address) > this.#options.endpoint.connectionsPerAddress) {
      closeWith(socket, closeReasons.tooMany);
    }
  }

  async #hello(client: Client, bytes: Buffer): Promise<void> {
    // Messages that arrived during the check of the first message.
    if (client.conversation !== null) return this.#handle(client, bytes);
    const { socket, port, id, language } = client;
    if (socket.readyState !== socket.OPEN) return;
    const { endpoint } = this.#options;
    const hello = decodeFrame(endpoint.helloSchema, bytes.toString(), MAX_HELLO_BYTES);
    if (!hello.ok) {
      const [first] = hello.problems;
      const detail = first && `The first message is not a valid hello. ${describeProblem(first)}`;
      return closeWith(socket, closeReasons.notAuthorised, detail);
    }
    const closing = endpoint.checkId(id);
    if (closing !== null) return closeWith(socket, closing.reason, closing.detail);
    const { role, key } = hello.value;
    const admitted = await endpoint.admit(id, hello.value, language);
    if (socket.readyState !== socket.OPEN) return;
    client.key = markOf(key);
    this.#options.log.info(
      { role, client: language, key: client.key },
      "WebSocket client authenticated",
    );
    client.conversation = admitted.start(port);
    client.cancelTimer();
    client.cancelTimer = nothing;
  }

  #handle(client: Client, bytes: Buffer): void {
    if (client.conversation === null) return;
    handleMessage(client.conversation, bytes, (error) => this.#refuse(client, error));
  }

  #refuse({ socket }: Client, error: unknown): void {
    closeOnError(error, socket, this.#options);
  }
}

/** The path of a request, without its query. */
function pathIn(url = ""): string {
  return url.split("?")[0] ?? "";
}
