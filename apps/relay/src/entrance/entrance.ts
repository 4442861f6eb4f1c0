/**
 * Where a request comes from and which address it asked for: what limits, robot addresses and the
 * checks of Host and Origin go by, for HTTP requests and WebSocket upgrades alike.
 */
import type { IncomingMessage } from "node:http";
import type { Config } from "../config.ts";
import { Refusal } from "../problems.ts";
import { visitorReader, type Visitor } from "./trusted-proxies.ts";

export class Entrance {
  readonly #publicOrigin: string | null;
  /** null: any name will do */
  readonly #hosts: ReadonlySet<string> | null;
  readonly #visitor: (request: IncomingMessage) => Visitor;

  constructor(config: Pick<Config, "publicOrigin" | "allowedHosts" | "trustedProxies">) {
    const { publicOrigin, allowedHosts, trustedProxies } = config;
    this.#publicOrigin = publicOrigin;
    const own = publicOrigin === null ? [] : [new URL(publicOrigin).hostname];
    this.#hosts = allowedHosts === null ? null : new Set([...allowedHosts, ...own]);
    this.#visitor = visitorReader(trustedProxies);
  }

  /** The visitor's IP address. It lives in memory only, for limits. */
  addressOf(request: IncomingMessage): string {
    return this.#visitor(request).address;
  }

  /** @throws Refusal when the request does not say for which host it is, or for one that is not served here */
  checkHost(request: IncomingMessage): void {
    if (request.headers.host === undefined && request.httpVersion !== "1.0") {
      throw new Refusal(
        "bad-request",
        "The header Host is missing. Every HTTP/1.1 request has it.",
      );
    }
    // Node keeps the first of several, a proxy in front may go by another.
    if (headersNamed("host", request) > 1) {
      throw new Refusal("bad-request", "The header Host is there more than once. Send it once.");
    }
    if (this.#hosts === null) return;
    const url = `http://${this.#visitor(request).host}`;
    if (URL.canParse(url) && this.#hosts.has(new URL(url).hostname)) return;
    throw new Refusal(
      "wrong-host",
      "This service is not known by the name in the header Host. Use its own address; whoever runs it lists its names in ALLOWED_HOSTS.",
    );
  }

  /**
   * The origin under which the visitor sees the service, such as https://robots.example.org.
   * @throws Refusal when the request does not say it
   */
  originOf(request: IncomingMessage): string {
    if (this.#publicOrigin !== null) return this.#publicOrigin;
    const { protocol, host } = this.#visitor(request);
    const url = `${protocol}://${host}`;
    if (!URL.canParse(url) || new URL(url).host !== host.toLowerCase()) {
      throw new Refusal("bad-request", "The header Host must name the address of this service.");
    }
    return new URL(url).origin;
  }

  /** Browsers always send Origin; without one it is a program, which needs a key anyway. */
  isOwnPage(request: IncomingMessage): boolean {
    const { origin } = request.headers;
    if (origin === undefined || origin === this.#publicOrigin) return true;
    return URL.canParse(origin) && new URL(origin).host === this.#visitor(request).host;
  }
}

/** How often a header came. @param name in small letters */
function headersNamed(name: string, { rawHeaders }: IncomingMessage): number {
  // Names and values by turns.
  return rawHeaders.filter((text, at) => at % 2 === 0 && text.toLowerCase() === name).length;
}
