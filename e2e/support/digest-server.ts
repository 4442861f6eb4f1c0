/**
 * A server whose page runs the product's simulator worker on given inputs and posts the digests
 * back. Any browser that can open an address can run it, without a driver.
 */
import { readFileSync, readdirSync, statSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";

const assets = new URL("../../apps/web/dist/assets/", import.meta.url);

/** A message of type "digest" for the worker. */
export type DigestMessage = Record<string, unknown>;

const page = `<!doctype html><meta charset="utf-8"><title>Digest</title>
<script type="module" src="/digest.js"></script>`;

const script = `
const messages = await (await fetch("/messages")).json();
const worker = new Worker("/assets/" + messages.worker, { type: "module" });
const digests = [];
const postNext = () => worker.postMessage(messages.list[digests.length]);
worker.onmessage = ({ data }) => {
  if (data.type === "digest") digests.push(data.digest);
  else if (data.type === "fault") digests.push("fault: " + data.reason);
  else return;
  if (digests.length < messages.list.length) postNext();
  else fetch("/digests", { method: "POST", body: JSON.stringify(digests) });
};
postNext();
`;

export class DigestServer {
  readonly #server: Server;
  /** the digests in the order of the messages, resolved once a browser has posted them */
  readonly digests: Promise<string[]>;

  private constructor(server: Server, digests: Promise<string[]>) {
    this.#server = server;
    this.digests = digests;
  }

  static async start(list: DigestMessage[]): Promise<DigestServer> {
    const scripts = readdirSync(assets).filter((name) => name.endsWith(".js"));
    // The worker and its lazy-loaded chunks.
    const files = new Set(scripts.map((name) => `/assets/${name}`));
    // The folder may still contain the chunks of an earlier build.
    const modified = (name: string): number => statSync(new URL(name, assets)).mtimeMs;
    const worker = scripts
      .filter((name) => name.startsWith("simulator.worker-"))
      .toSorted((a, b) => modified(b) - modified(a))[0];
    if (worker === undefined) throw new Error("no worker in apps/web/dist: run npm run build");
    const { promise, resolve } = Promise.withResolvers<string[]>();
    const server = createServer((request, response) => {
      const path = request.url ?? "/";
      const answer = (type: string, body: string): void => {
        response.writeHead(200, { "content-type": type }).end(body);
      };
      if (path === "/digests") {
        let body = "";
        request.on("data", (chunk) => (body += chunk));
        request.on("end", () => {
          answer("text/plain", "");
          resolve(JSON.parse(body));
        });
      } else if (path === "/digest.js") answer("text/javascript", script);
      else if (path === "/messages") answer("application/json", JSON.stringify({ worker, list }));
      else if (files.has(path)) {
        answer(
          "text/javascript",
          readFileSync(new URL(path.slice("/assets/".length), assets), "utf8"),
        );
      } else if (path === "/") answer("text/html", page);
      else response.writeHead(404).end();
    });
    await new Promise<void>((listening) => server.listen(0, "127.0.0.1", listening));
    return new DigestServer(server, promise);
  }

  get url(): string {
    return `http://127.0.0.1:${(this.#server.address() as AddressInfo).port}/`;
  }

  close(): void {
    this.#server.close();
    this.#server.closeAllConnections();
  }
}
