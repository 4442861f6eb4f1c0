/**
 * Client address and requested origin of HTTP requests and WebSocket upgrades. Rate limits, robot
 * addresses and the Host and Origin checks use them.
 */
import type { IncomingMessage } from "node:http";
import { Refusal } from "../errors/problems.ts";
import { visitorReader, type TrustedProxies, type Visitor } from "./trusted-proxies.ts";

export interface RequestGuardOptions {
  /** the service's origin; null: the one that the client requested */
  publicOrigin: string | null;
  /** accepted host names; null: any */
  allowedHosts: readonly string[] | null;
  trustedProxies: TrustedProxies;
}

export class RequestGuard {
  readonly #publicOrigin: string | null;
  /** null: any host */
  readonly #hosts: ReadonlySet<string> | null;
  readonly #visitor: (request: IncomingMessage) => Visitor;

  constructor(options: RequestGuardOptions) {
    const { publicOrigin, allowedHosts, trustedProxies } = options;
    this.#publicOrigin = publicOrigin;
    const own = publicOrigin === null ? [] : [new URL(publicOrigin).hostname];
    this.#hosts = allowedHosts === null ? null : new Set([...allowedHosts, ...own]);
    this.#visitor = visitorReader(trustedProxies);
  }

  /** IP address of the client. It is used for limits only and never stored. */
  addressOf(request: IncomingMessage): string {
    return this.#visitor(request).address;
  }

  /** @throws Refusal if the Host header is missing, repeated or not an allowed host */
  checkHost(request: IncomingMessage): void {
    requireOneHost(request);
    if (this.#hosts === null) return;
    const url = `http://${this.#visitor(request).host}`;
    if (URL.canParse(url) && this.#hosts.has(new URL(url).hostname)) return;
    throw new Refusal(
      "wrong-host",
      "Unknown name in the header Host. Use the address of this service. Its operator lists its names in ALLOWED_HOSTS.",
    );
  }

  /**
   * Origin of the service as the client sees it, such as https://robots.example.org.
   * @throws Refusal if the request has no valid host
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

  /** Browsers always send Origin. A request without it comes from a program, which needs a key. */
  isOwnPage(request: IncomingMessage): boolean {
    const { origin } = request.headers;
    if (origin === undefined || origin === this.#publicOrigin) return true;
    return URL.canParse(origin) && new URL(origin).host === this.#visitor(request).host;
  }

  /** Whether a program, a page of this service, or a page of the user's own machine requests. */
  isOwnOrLocal(request: IncomingMessage): boolean {
    const { origin = "" } = request.headers;
    if (this.isOwnPage(request)) return true;
    return URL.canParse(origin) && LOOPBACK.has(new URL(origin).hostname);
  }
}

const LOOPBACK: ReadonlySet<string> = new Set(["localhost", "127.0.0.1", "[::1]"]);

/**
 * Every HTTP/1.1 request has exactly one Host header, whatever its path (RFC 9112, section 3.2).
 * @throws Refusal if the header is missing or repeated
 */
export function requireOneHost(request: IncomingMessage): void {
  if (request.headers.host === undefined && request.httpVersion !== "1.0") {
    throw new Refusal(
      "bad-request",
      "The header Host is missing. HTTP/1.1 requires it in every request.",
    );
  }
  // Node uses the first of several Host headers, and a proxy may use another.
  if (countHeaders("host", request) > 1) {
    throw new Refusal("bad-request", "The request has more than one Host header. Send it once.");
  }
}

/** Number of headers with a name. @param name in lower case */
function countHeaders(name: string, { rawHeaders }: IncomingMessage): number {
  // Names and values alternate.
  return rawHeaders.filter((text, at) => at % 2 === 0 && text.toLowerCase() === name).length;
}
