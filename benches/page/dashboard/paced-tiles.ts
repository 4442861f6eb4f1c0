/**
 * A relay whose tiles arrive as fast as the dashboard reads them: a proxy that forwards everything
 * to the real relay except the messages of the dashboard's WebSocket after its welcome. The tiles of
 * two hours would take the real relay two hours.
 */
import { createServer, request, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import type { StudentTile } from "@corridor/protocol";
import { WebSocket, WebSocketServer } from "ws";

/** Batches that the dashboard has not acknowledged, as at the relay. */
const CREDIT = 2;

export class PacedTiles {
  readonly #server: Server;
  readonly #sockets = new WebSocketServer({ noServer: true });
  #dashboard: WebSocket | null = null;
  #seq = 0;
  #onSeen: (seq: number) => void = () => undefined;

  private constructor(relay: string) {
    this.#server = createServer((incoming, outgoing) => {
      const { method, headers } = incoming;
      const forwarded = request(new URL(incoming.url ?? "/", relay), { method, headers });
      forwarded.on("error", () => outgoing.destroy());
      forwarded.on("response", (response) => {
        outgoing.writeHead(response.statusCode ?? 502, response.headers);
        response.pipe(outgoing);
      });
      incoming.pipe(forwarded);
    });
    this.#server.on("upgrade", (incoming, socket, head) => {
      this.#sockets.handleUpgrade(incoming, socket, head, (dashboard) => {
        this.#connect(dashboard, new WebSocket(`${relay.replace("http", "ws")}${incoming.url}`));
      });
    });
  }

  static async start(relay: string): Promise<PacedTiles> {
    const proxy = new PacedTiles(relay);
    await new Promise<void>((listening) => proxy.#server.listen(0, "127.0.0.1", listening));
    return proxy;
  }

  get url(): string {
    return `http://localhost:${(this.#server.address() as AddressInfo).port}`;
  }

  /** Sends batches, and waits until the dashboard has read all of them. */
  async send(count: number, batch: (n: number) => StudentTile[]): Promise<void> {
    let sent = 0;
    const first = this.#seq;
    await new Promise<void>((resolve) => {
      const advance = (seen: number): void => {
        if (seen - first >= count) resolve();
        while (sent < count && this.#seq - seen < CREDIT) {
          const message = { type: "tiles", seq: ++this.#seq, tiles: batch(sent++) };
          this.#dashboard?.send(JSON.stringify(message));
        }
      };
      this.#onSeen = advance;
      advance(first);
    });
  }

  async close(): Promise<void> {
    this.#dashboard?.terminate();
    const closed = new Promise<void>((resolve) => this.#server.close(() => resolve()));
    this.#server.closeAllConnections();
    await closed;
  }

  #connect(dashboard: WebSocket, relay: WebSocket): void {
    this.#dashboard = dashboard;
    const opened = new Promise((resolve) => relay.once("open", resolve));
    relay.on("message", (data: Buffer) => {
      const text = data.toString();
      if (!text.startsWith('{"type":"tiles"')) dashboard.send(text);
    });
    dashboard.on("message", (data: Buffer) => {
      const text = data.toString();
      const { type, seq } = JSON.parse(text) as { type: string; seq?: number };
      if (type === "seen") this.#onSeen(seq ?? 0);
      else void opened.then(() => relay.send(text));
    });
    dashboard.on("close", () => relay.close());
    relay.on("close", (code) => dashboard.close(code >= 3000 ? code : 1000));
  }
}
