/**
 * An HTTP proxy in front of the relay. Tests close it to go offline, and let it serve a newer build
 * of the page: the same files, with an attribute on the document and a service worker that lists
 * the change.
 */
import { createServer, request, type IncomingMessage, type Server } from "node:http";
import type { AddressInfo } from "node:net";

/** value of the newer build's data-build attribute */
export const NEWER_BUILD = "newer";

export class RelayProxy {
  readonly #server: Server;
  readonly #relay: string;
  #isNewer = false;

  private constructor(relay: string) {
    this.#relay = relay;
    this.#server = createServer((incoming, outgoing) => {
      // Request full, uncompressed responses, so that the body can be changed.
      const headers = { ...incoming.headers, "accept-encoding": "identity" };
      delete headers["if-none-match"];
      delete headers["if-modified-since"];
      const forwarded = request(new URL(incoming.url ?? "/", this.#relay), {
        method: incoming.method,
        headers,
      });
      forwarded.on("error", () => outgoing.destroy());
      forwarded.on("response", (response) => {
        void textOf(response).then((body) => {
          const changedBody = this.#isNewer ? asNewerBuild(incoming.url ?? "/", body) : body;
          const { "content-length": _, etag: __, ...rest } = response.headers;
          outgoing.writeHead(response.statusCode ?? 502, rest).end(changedBody);
        });
      });
      incoming.pipe(forwarded);
    });
  }

  /** @param relay address of the relay behind the proxy */
  static async start(relay: string): Promise<RelayProxy> {
    const proxy = new RelayProxy(relay);
    await new Promise<void>((listening) => proxy.#server.listen(0, "127.0.0.1", listening));
    return proxy;
  }

  get url(): string {
    return `http://localhost:${(this.#server.address() as AddressInfo).port}`;
  }

  /** Serves the newer build from now on. */
  serveNewerBuild(): void {
    this.#isNewer = true;
  }

  async close(): Promise<void> {
    const closed = new Promise<void>((resolve) => this.#server.close(() => resolve()));
    this.#server.closeAllConnections();
    await closed;
  }
}

async function textOf(response: IncomingMessage): Promise<Buffer> {
  const parts: Buffer[] = [];
  for await (const part of response) parts.push(part as Buffer);
  return Buffer.concat(parts);
}

/** @throws when there is nothing to change: the newer build would equal the current one */
function asNewerBuild(path: string, body: Buffer): Buffer {
  if (path !== "/" && path !== "/sw.js" && !path.startsWith("/index.html")) return body;
  const text = body.toString("utf8");
  const changedBody =
    path === "/sw.js"
      ? text.replace(
          /(url:"index\.html",revision:"|revision:"(?=[0-9a-f]+",url:"index\.html"))/,
          "$1b",
        )
      : text.replace("<html ", `<html data-build="${NEWER_BUILD}" `);
  if (changedBody === text) throw new Error(`nothing to change in ${path}`);
  return Buffer.from(changedBody);
}
