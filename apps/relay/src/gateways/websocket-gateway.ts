/**
 * WebSockets of pages and scripts: who may connect, who they are, and that they are alive.
 *
 * Nothing is trusted before the first message: one message of at most 1 KiB within 5 seconds, with a
 * key. After that the socket speaks as a page or as a script (see the conversations beside this).
 */
import type { IncomingMessage } from "node:http";
import type { Duplex } from "node:stream";
import {
  closeReasons,
  decodeFrame,
  describeProblem,
  helloSchema,
  MAX_FRAME_BYTES,
  MAX_HELLO_BYTES,
  robotIdSchema,
} from "@corridor/protocol";
import type { Logger } from "pino";
import { WebSocketServer, type WebSocket } from "ws";
import { clientName } from "../client-name.ts";
import type { Clock } from "../clock.ts";
import { markOf } from "../keys.ts";
import type { Entrance } from "../entrance/entrance.ts";
import type { Metrics } from "../metrics/metrics.ts";
import { asRefusal, Refusal } from "../problems.ts";
import { limits } from "../sessions/limits.ts";
import { verbOfRole } from "../sessions/rights.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import { Sweep } from "../sweep.ts";
import { closeWith, hear, type Conversation } from "./conversation.ts";
import { closeFor, converse, introduced } from "./converse.ts";
import { hearPlainTexts } from "./plain-texts.ts";
import type { ReaderLine } from "./reader-line.ts";
import { refuseUpgrade } from "./refuse-upgrade.ts";
import { SpeakingSocket } from "./speaking-socket.ts";
import { WsPort } from "./ws-port.ts";

const nothing = (): void => undefined;

/**
 * Close codes of a client that closes by itself: 1001 is a tab that is closed or reloaded, 1005 says nothing
 * more. With a code of the relay's own it only answers, and what it said last was not heard.
 */
const goodbyes: ReadonlySet<number> = new Set([1000, 1001, 1005]);

const PATH = /^\/api\/v1\/robots\/([^/]{1,64})\/socket$/;

interface Guest {
  socket: WebSocket;
  port: ReaderLine;
  /** of the robot, as the address says it */
  id: string;
  /** the script's language, such as "Python" */
  client: string;
  /** ends the wait for its first message */
  cancelTimer: () => void;
  heardAt: number;
  /** when it last received a heartbeat */
  beatAt: number;
  /** what the log may show of its key */
  key: string | null;
  conversation: Conversation | null;
}

export interface GatewayOptions {
  hub: SessionHub;
  clock: Clock;
  log: Logger;
  entrance: Entrance;
  metrics: Metrics;
}

export class WebSocketGateway {
  readonly #options: GatewayOptions;
  readonly #server = new WebSocketServer({
    noServer: true,
    maxPayload: MAX_FRAME_BYTES,
    perMessageDeflate: false,
    clientTracking: false,
    WebSocket: SpeakingSocket,
  });
  readonly #guests = new Set<Guest>();
  /** how many come from each address */
  readonly #ofAddress = new Map<string, number>();
  readonly #heartbeats: Sweep<Guest>;

  constructor(options: GatewayOptions) {
    this.#options = options;
    this.#heartbeats = new Sweep({
      clock: options.clock,
      everyMs: limits.silenceCheckMs,
      members: () => this.#guests,
      visit: (guest) => this.#beat(guest),
    });
  }

  /** Takes an upgrade request of the HTTP server; a wrong one gets a problem document. */
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
      this.#welcome(webSocket, socket, { request, id });
    });
  }

  /** Closes every socket because the relay stops. */
  close(): void {
    this.#heartbeats.close();
    for (const { socket } of this.#guests) closeWith(socket, closeReasons.restart);
    this.#server.close();
  }

  /** Cuts those off who did not answer the goodbye. */
  cut(): void {
    for (const { socket } of this.#guests) socket.terminate();
  }

  /** @returns the robot's id in the address @throws Refusal when no socket may be opened there */
  #admit(request: IncomingMessage): string {
    const { entrance } = this.#options;
    entrance.checkHost(request);
    const id = PATH.exec((request.url ?? "").split("?")[0] ?? "")?.[1];
    if (id === undefined) {
      throw new Refusal("not-found", "WebSockets are at /api/v1/robots/ID/socket only.");
    }
    if (!entrance.isOwnPage(request)) {
      throw new Refusal(
        "forbidden",
        "Pages of other sites cannot open this socket. Use the HTTP API.",
      );
    }
    return id;
  }

  /** Nothing here holds on to the request: with its headers it is larger than all else of a quiet guest. */
  #welcome(
    socket: WebSocket,
    connection: Duplex,
    { request, id }: { request: IncomingMessage; id: string },
  ): void {
    const { clock, entrance, metrics } = this.#options;
    const address = entrance.addressOf(request);
    const guest: Guest = {
      socket,
      port: new WsPort(socket, connection, clock),
      id,
      client: clientName(request.headers["user-agent"]),
      cancelTimer: clock.after(limits.helloMs, () => {
        if (guest.conversation === null) closeWith(socket, closeReasons.notAuthorised);
      }),
      heardAt: clock.now(),
      beatAt: clock.now(),
      key: null,
      conversation: null,
    };
    this.#guests.add(guest);
    const ofAddress = (this.#ofAddress.get(address) ?? 0) + 1;
    this.#ofAddress.set(address, ofAddress);
    // Messages are taken one after the other, so that nothing overtakes the first.
    let work: Promise<void> = Promise.resolve();
    const hear = (data: Buffer, isBinary: boolean): void => {
      // Messages still come while a socket closes; nobody would get the answers.
      if (!guest.port.isOpen) return;
      guest.heardAt = clock.now();
      if (isBinary) return closeWith(socket, closeReasons.badFrame, "Send text, not bytes.");
      if (guest.conversation !== null) return this.#hear(guest, data);
      work = work
        .then(() => this.#hello(guest, data))
        .catch((error: unknown) => this.#refuse(guest, error));
    };
    socket.on("message", hear);
    hearPlainTexts(connection, (bytes) => hear(bytes, false));
    socket.on("pong", () => (guest.heardAt = clock.now()));
    // Too large a message or broken framing: ws closes the socket itself, with 1009 or 1002.
    socket.on("error", (error) => this.#options.log.debug({ err: error }, "a socket broke"));
    socket.on("close", (code) => {
      metrics.socketClosed(code);
      this.#options.log.info({ code, key: guest.key }, "a socket was closed");
      guest.cancelTimer();
      this.#guests.delete(guest);
      this.#left(address);
      guest.conversation?.closed(goodbyes.has(code));
    });
    if (ofAddress > limits.socketsPerAddress) closeWith(socket, closeReasons.tooMany);
  }

  #left(address: string): void {
    const others = (this.#ofAddress.get(address) ?? 1) - 1;
    if (others > 0) this.#ofAddress.set(address, others);
    else this.#ofAddress.delete(address);
  }

  async #hello(guest: Guest, bytes: Buffer): Promise<void> {
    // Messages that came while the first was still being checked.
    if (guest.conversation !== null) return this.#hear(guest, bytes);
    const { socket, port, id, client } = guest;
    if (socket.readyState !== socket.OPEN) return;
    const hello = decodeFrame(helloSchema, bytes.toString(), MAX_HELLO_BYTES);
    if (!hello.ok) {
      const [first] = hello.problems;
      const detail = first && `The first message is no hello. ${describeProblem(first)}`;
      return closeWith(socket, closeReasons.notAuthorised, detail);
    }
    if (!robotIdSchema.safeParse(id).success) return closeWith(socket, closeReasons.noRobot);
    const { role, key } = hello.value;
    const introduction = introduced(hello.value, client);
    const grant = await this.#options.hub.authorise(id, key, verbOfRole[role], introduction);
    if (socket.readyState !== socket.OPEN) return;
    guest.key = markOf(key);
    this.#options.log.info({ role, client, key: guest.key }, "a socket said hello");
    guest.conversation = converse({
      hello: hello.value,
      grant,
      line: port,
      metrics: this.#options.metrics,
      clock: this.#options.clock,
    });
    guest.cancelTimer();
    guest.cancelTimer = nothing;
  }

  #hear(guest: Guest, bytes: Buffer): void {
    if (guest.conversation === null) return;
    hear(guest.conversation, bytes, (error) => this.#refuse(guest, error));
  }

  #refuse({ socket }: Guest, error: unknown): void {
    closeFor(error, socket, this.#options);
  }

  #beat(guest: Guest): void {
    const now = this.#options.clock.now();
    const silentMs = now - guest.heardAt;
    if (silentMs >= limits.silenceMs) return guest.socket.terminate();
    // Half a check early rather than half a check late, since checks wander by some ms.
    const isDue = now - guest.beatAt >= limits.heartbeatMs - limits.silenceCheckMs / 2;
    if (isDue && guest.socket.readyState === guest.socket.OPEN) {
      guest.beatAt = now;
      // Whoever speaks lives, and is not asked. An answer to the ping before came a while after that.
      if (silentMs >= limits.heartbeatMs / 2) guest.socket.ping();
      guest.conversation?.heartbeat();
    }
  }
}
