/** One connection of a ROS client: authentication, liveness, and its session with the robot. */
import { closeReasons, protocolClients, RefusedError } from "@corridor/protocol";
import { closeReasonFor, keyInAuth, RosSession } from "@corridor/ros";
import type { Logger } from "pino";
import type { WebSocket } from "ws";
import { asRefusal, Refusal } from "../../platform/errors/problems.ts";
import { keyId } from "../../platform/keys.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { Grant } from "../../robots/registry.ts";
import { RelayPort } from "../../robots/relay-port.ts";
import { closeWith } from "../conversations/conversation.ts";
import { UnauthenticatedMessages } from "../conversations/unauthenticated-messages.ts";
import type { GatewayMetrics } from "../conversations/start-conversation.ts";
import type { OpenSocket } from "../websocket/open-sockets.ts";
import type { WsPort } from "../websocket/ws-port.ts";

/** Timeout for a key. */
const AUTH_MS = 2_000;

export interface RosConnectionOptions {
  socket: WebSocket;
  port: WsPort;
  /** @throws Refusal as `RobotRegistry.authorise` */
  authorise: (key: string) => Promise<Grant>;
  clock: Clock;
  log: Logger;
  metrics: GatewayMetrics;
}

/** What the key of the upgrade request permits. */
export interface Admission {
  grant: Grant;
  /** The key is in the path, so that one in the first message takes precedence. */
  isInPath: boolean;
}

export class RosConnection implements OpenSocket {
  readonly socket: WebSocket;
  readonly #port: WsPort;
  lastMessageAt: number;
  lastHeartbeatAt: number;
  readonly #options: RosConnectionOptions;
  #session: RosSession | null = null;
  /** what arrived before the key was checked */
  #waiting: string[] = [];
  readonly #unauthenticated = new UnauthenticatedMessages();
  #isChecking = false;
  /** whether a key in the path permits this session, and the first message may bring another key */
  #mayChangeKey = false;
  #cancelTimer = (): void => undefined;

  constructor(options: RosConnectionOptions) {
    this.#options = options;
    this.#port = options.port;
    const { socket, clock, log, metrics } = options;
    this.socket = socket;
    this.lastMessageAt = clock.now();
    this.lastHeartbeatAt = clock.now();
    // ROS# sends its JSON as binary messages.
    socket.on("message", (data: Buffer) => this.#receive(data.toString()));
    socket.on("pong", () => (this.lastMessageAt = clock.now()));
    // On oversized messages or broken framing, `ws` closes the socket with 1009 or 1002.
    socket.on("error", (error) => log.debug({ err: error }, "ROS connection error"));
    socket.on("close", (code) => {
      metrics.socketClosed(code);
      log.info({ code }, "ROS connection closed");
      this.#cancelTimer();
      this.#session?.disconnected(code);
      this.#session = null;
      this.#waiting = [];
    });
  }

  /** @param admission what the key of the upgrade request permits; null: it had none */
  open(admission: Admission | null): void {
    if (admission !== null) {
      this.#mayChangeKey = admission.isInPath;
      return this.#start(admission.grant);
    }
    this.#cancelTimer = this.#options.clock.after(AUTH_MS, () => this.#closeWithoutKey());
  }

  #receive(text: string): void {
    if (!this.#port.isOpen) return;
    this.lastMessageAt = this.#options.clock.now();
    this.#options.metrics.gatewayMessage("ros");
    const session = this.#session;
    const isKeyExpected = session === null ? !this.#isChecking : this.#mayChangeKey;
    this.#mayChangeKey = false;
    const key = isKeyExpected ? keyInAuth(text) : null;
    if (key !== null) return void this.#authenticate(key);
    if (session !== null) return this.#handle(session, text);
    this.#waiting.push(text);
    if (!this.#unauthenticated.accepts(text.length)) this.#closeWithoutKey();
  }

  #handle(session: RosSession, text: string): void {
    if (!session.receive(text)) this.#options.metrics.refused("bad-request");
  }

  async #authenticate(key: string): Promise<void> {
    this.#isChecking = true;
    this.#cancelTimer();
    this.#session?.close();
    this.#session = null;
    try {
      const grant = await this.#options.authorise(key);
      if (this.#port.isOpen) this.#start(grant);
    } catch (error) {
      this.#close(error);
    }
  }

  #start(grant: Grant): void {
    this.#cancelTimer();
    const { robot, caller } = grant;
    const { clock, log } = this.#options;
    try {
      const session = new RosSession({
        port: new RelayPort(grant, { transport: this.#port.transport, flow: this.#port.flow }),
        timers: clock,
        send: (text) => this.#port.send(text),
        close: (reason, detail) => closeWith(this.#port, reason, detail),
        onProblem: (error) =>
          robot.refused(
            caller,
            error instanceof RefusedError ? error : new Refusal("bad-request", error.message),
          ),
        onFailure: (error) => this.#close(error),
        onEnd: (error) => this.#close(error.cause ?? error),
      });
      this.#session = session;
      robot.spoke(caller);
      log.info(
        { client: protocolClients.ros, key: keyId(caller.hash) },
        "ROS client authenticated",
      );
      const waiting = this.#waiting;
      this.#waiting = [];
      for (const text of waiting) if (this.#port.isOpen) this.#handle(session, text);
    } catch (error) {
      this.#close(error instanceof RefusedError ? (error.cause ?? error) : error);
    }
  }

  #closeWithoutKey(): void {
    closeWith(
      this.#port,
      closeReasons.notAuthorised,
      "No key in time. Send it in the header Authorization, or as 'mac' of the operation auth.",
    );
  }

  #close(error: unknown): void {
    const refusal = asRefusal(error);
    this.#options.metrics.refused(refusal.kind);
    if (refusal.kind === "internal") {
      this.#options.log.error({ err: error }, "a ROS connection failed");
    }
    closeWith(this.#port, closeReasonFor(refusal.problem), refusal.problem.detail);
  }
}
