/**
 * WebSockets of ROS clients, by rosbridge v2. A key in the header or the path is checked before the
 * connection opens. Without one, messages wait until an operation `auth` arrives; as the first message,
 * its key takes precedence over one in the path. Pages of all sites may connect, because permissions
 * come from the key alone.
 */
import type { IncomingMessage } from "node:http";
import type { Duplex } from "node:stream";
import { MAX_FRAME_BYTES, protocolClients } from "@corridor/protocol";
import type { Logger } from "pino";
import { WebSocketServer, type WebSocket } from "ws";
import { asRefusal, Refusal } from "../../platform/errors/problems.ts";
import { readBearer } from "../../platform/http/reading.ts";
import { refuseUpgrade } from "../../platform/http/refuse-upgrade.ts";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { Introduction } from "../../robots/access/callers.ts";
import type { RobotRegistry } from "../../robots/registry.ts";
import type { GatewayMetrics } from "../conversations/start-conversation.ts";
import { gatewayDisabled } from "../requests/gateway-requests.ts";
import { OpenSockets } from "../websocket/open-sockets.ts";
import { SocketWithReasons } from "../websocket/socket-with-reasons.ts";
import { WsPort } from "../websocket/ws-port.ts";
import { RosConnection, type Admission } from "./ros-connection.ts";

const PATH = /^\/r\/([^/?]{1,64})\/ros(?:\/([^/?]{1,128}))?\/?(?:\?|$)/;
const introduction: Introduction = { client: protocolClients.ros, name: null };

export interface RosGatewayOptions {
  registry: RobotRegistry;
  clock: Clock;
  log: Logger;
  guard: RequestGuard;
  metrics: GatewayMetrics;
  /** false: the operator has switched it off */
  isOn: boolean;
}

export class RosGateway {
  readonly #options: RosGatewayOptions;
  readonly #server = new WebSocketServer({
    noServer: true,
    maxPayload: MAX_FRAME_BYTES,
    perMessageDeflate: false,
    clientTracking: false,
    WebSocket: SocketWithReasons,
  });
  readonly #connections: OpenSockets<RosConnection>;

  constructor(options: RosGatewayOptions) {
    this.#options = options;
    this.#connections = new OpenSockets({ clock: options.clock });
  }

  /** Whether a request is for the URL of a robot for ROS clients. */
  isFor({ url = "" }: IncomingMessage): boolean {
    return PATH.test(url);
  }

  /** Handles an upgrade request. An invalid one receives a problem document. */
  upgrade(request: IncomingMessage, socket: Duplex, head: Buffer): void {
    // A connection error also emits "close".
    const ignore = (): void => undefined;
    socket.on("error", ignore);
    this.#admit(request).then(
      (admission) => {
        socket.off("error", ignore);
        this.#server.handleUpgrade(request, socket, head, (webSocket) => {
          this.#accept(webSocket, socket, { request, admission });
        });
      },
      (error: unknown) => {
        const refusal = asRefusal(error);
        this.#options.metrics.refused(refusal.kind);
        if (refusal.kind === "internal") {
          this.#options.log.error({ err: error }, "opening a ROS connection failed");
        }
        refuseUpgrade(socket, refusal);
      },
    );
  }

  /** Closes all connections because the relay shuts down. */
  close(): void {
    this.#connections.close();
    this.#server.close();
  }

  /** Destroys the connections that did not answer the close frame. */
  destroyAll(): void {
    this.#connections.destroyAll();
  }

  /** @returns what its key permits; null: the request has no key @throws Refusal */
  async #admit(request: IncomingMessage): Promise<Admission | null> {
    const { guard, registry, isOn } = this.#options;
    guard.checkHost(request);
    if (!isOn) throw gatewayDisabled("ros");
    const [, id = "", pathKey] = PATH.exec(request.url ?? "") ?? [];
    const address = guard.addressOf(request);
    if (this.#connections.countOf(address) >= limits.socketsPerAddress) {
      throw new Refusal("too-many-readers", "Too many connections from this address.");
    }
    const key = readBearer(request);
    if (key !== null) {
      return {
        grant: await registry.authorise(id, key, "read", introduction),
        isInPath: false,
      };
    }
    if (pathKey === undefined) return null;
    const grant = await registry.authorise(id, pathKey, "read", introduction, "url");
    return { grant, isInPath: true };
  }

  #accept(
    socket: WebSocket,
    stream: Duplex,
    { request, admission }: { request: IncomingMessage; admission: Admission | null },
  ): void {
    const { registry, guard, metrics, log, clock } = this.#options;
    const address = guard.addressOf(request);
    const [, id = ""] = PATH.exec(request.url ?? "") ?? [];
    const connection = new RosConnection({
      socket,
      port: new WsPort(socket, stream, clock),
      authorise: (key) => registry.authorise(id, key, "read", introduction),
      clock,
      log,
      metrics,
    });
    this.#connections.add(connection, address);
    socket.on("close", () => this.#connections.remove(connection, address));
    connection.open(admission);
  }
}
