/**
 * A door in front of the relay that can be shut, and that can show a newer build of the page: the same
 * files, with a mark on the document and a service worker that knows of the change.
 */
import { createServer, request, type IncomingMessage, type Server } from "node:http";
import type { AddressInfo } from "node:net";

/** What the newer build's document says of itself. */
export const NEWER_MARK = "newer";

export class FrontDoor {
  readonly #server: Server;
  readonly #relay: string;
  #isNewer = false;

  private constructor(relay: string) {
    this.#relay = relay;
    this.#server = createServer((asked, answer) => {
      // Whole and plain, so that it can be changed: no "you have it already", nothing compressed.
      const headers = { ...asked.headers, "accept-encoding": "identity" };
      delete headers["if-none-match"];
      delete headers["if-modified-since"];
      const onward = request(new URL(asked.url ?? "/", this.#relay), {
        method: asked.method,
        headers,
      });
      onward.on("error", () => answer.destroy());
      onward.on("response", (response) => {
        void textOf(response).then((body) => {
          const changed = this.#isNewer ? newer(asked.url ?? "/", body) : body;
          const { "content-length": _, etag: __, ...rest } = response.headers;
          answer.writeHead(response.statusCode ?? 502, rest).end(changed);
        });
      });
      asked.pipe(onward);
    });
  }

  /** @param relay address of the relay behind it */
  static async open(relay: string): Promise<FrontDoor> {
    const door = new FrontDoor(relay);
    await new Promise<void>((listening) => door.#server.listen(0, "127.0.0.1", listening));
    return door;
  }

  get url(): string {
    return `http://localhost:${(this.#server.address() as AddressInfo).port}`;
  }

  /** From now on, who asks gets the newer build. */
  showNewerBuild(): void {
    this.#isNewer = true;
  }

  async shut(): Promise<void> {
    const closed = new Promise<void>((done) => this.#server.close(() => done()));
    this.#server.closeAllConnections();
    await closed;
  }
}

async function textOf(response: IncomingMessage): Promise<Buffer> {
  const parts: Buffer[] = [];
  for await (const part of response) parts.push(part as Buffer);
  return Buffer.concat(parts);
}

/** @throws when the build is not what this expects: then the newer one would be the same */
function newer(path: string, body: Buffer): Buffer {
  if (path !== "/" && path !== "/sw.js" && !path.startsWith("/index.html")) return body;
  const text = body.toString("utf8");
  const changed =
    path === "/sw.js"
      ? text.replace(
          /(url:"index\.html",revision:"|revision:"(?=[0-9a-f]+",url:"index\.html"))/,
          "$1b",
        )
      : text.replace("<html ", `<html data-build="${NEWER_MARK}" `);
  if (changed === text) throw new Error(`nothing to change in ${path}`);
  return Buffer.from(changed);
}
