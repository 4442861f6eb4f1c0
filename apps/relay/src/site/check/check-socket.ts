/** The WebSocket of /check: echoes messages for up to a minute, without authentication. */
import type { IncomingMessage } from "node:http";
import type { Duplex } from "node:stream";
import { WebSocketServer, type WebSocket } from "ws";
import type { Clock } from "../../platform/time/clock.ts";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import { asRefusal, Refusal } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { refuseUpgrade } from "../../platform/http/refuse-upgrade.ts";

const PATH = "/check/socket";
const LIFE_MS = 60_000;
const MAX_MESSAGES = 20;

export class CheckSocket {
  readonly #guard: RequestGuard;
  readonly #clock: Clock;
  readonly #server = new WebSocketServer({
    noServer: true,
    maxPayload: 256,
    perMessageDeflate: false,
  });

  constructor(guard: RequestGuard, clock: Clock) {
    this.#guard = guard;
    this.#clock = clock;
  }

  isFor(request: IncomingMessage): boolean {
    return request.url === PATH;
  }

  upgrade(request: IncomingMessage, socket: Duplex, head: Buffer): void {
    try {
      this.#guard.checkHost(request);
      if (!this.#guard.isOwnPage(request)) {
        throw new Refusal("forbidden", "Pages of other sites cannot open this socket.");
      }
      if (this.#server.clients.size >= limits.heldChecks) {
        throw new Refusal(
          "too-many-readers",
          "Too many network checks are running. Try again in a minute.",
        );
      }
    } catch (error) {
      return refuseUpgrade(socket, asRefusal(error));
    }
    this.#server.handleUpgrade(request, socket, head, (opened) => this.#echo(opened));
  }

  close(): void {
    for (const socket of this.#server.clients) socket.terminate();
    this.#server.close();
  }

  #echo(socket: WebSocket): void {
    let remaining = MAX_MESSAGES;
    const cancel = this.#clock.after(LIFE_MS, () => socket.terminate());
    socket.on("message", (data: Buffer, isBinary) => {
      remaining -= 1;
      if (remaining < 0 || isBinary) socket.close(1008);
      else socket.send(data.toString("utf8"));
    });
    // A connection error also emits "close".
    socket.on("error", () => undefined);
    socket.on("close", cancel);
  }
}
