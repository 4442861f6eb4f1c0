import { createServer, request, type IncomingMessage } from "node:http";
import { connect, type AddressInfo, type Socket } from "node:net";
import type { Duplex } from "node:stream";

export type FilterMode =
  /** forwards everything */
  | "none"
  /** removes the header Upgrade, so that the relay receives an ordinary request */
  | "stripped"
  /** closes the connections of upgrades */
  | "blocked"
  /** forwards the response to an upgrade, and then nothing */
  | "silent"
  /** closes each WebSocket shortly after it was opened */
  | "cut early"
  /** closes idle sockets and aborts waiting requests after a short time */
  | "impatient"
  /** delays responses until they have ended; responds to upgrades with a web page */
  | "buffering";

/** A proxy as schools use them, which interferes with some requests. */
export interface FilterProxy {
  origin: string;
  mode: FilterMode;
  /** number of opened WebSockets */
  upgrades: number;
  /** number of requests */
  requests: number;
  /** number of connections that it has cut after `timeoutMs` */
  cuts: number;
  close(): void;
}

/**
 * Starts a proxy in front of a relay.
 * @param timeoutMs for `cut early` and `impatient`
 */
export async function openFilterProxy(
  relay: string,
  mode: FilterMode,
  timeoutMs: number,
): Promise<FilterProxy> {
  const target = new URL(relay);
  const close = (): void => {
    for (const socket of sockets) socket.destroy();
    server.closeAllConnections();
    server.close();
  };
  const proxy: FilterProxy = { origin: "", mode, upgrades: 0, requests: 0, cuts: 0, close };
  const sockets = new Set<Duplex>();

  const cutLate = (socket: Duplex): void => {
    proxy.cuts += 1;
    socket.destroy();
  };

  const server = createServer((incoming, answer) => {
    proxy.requests += 1;
    const outgoing = request(
      {
        host: target.hostname,
        port: target.port,
        path: incoming.url,
        method: incoming.method,
        headers: headersFor(incoming),
      },
      (got) => {
        if (proxy.mode === "buffering") {
          const parts: Buffer[] = [];
          got.on("data", (part: Buffer) => parts.push(part));
          got.on("end", () => answer.writeHead(got.statusCode ?? 502).end(Buffer.concat(parts)));
        } else {
          answer.writeHead(got.statusCode ?? 502, got.headers);
          got.pipe(answer);
        }
      },
    );
    const cut = (): void => void incoming.socket.destroy();
    outgoing.on("error", cut);
    if (proxy.mode === "impatient") outgoing.setTimeout(timeoutMs, () => cutLate(incoming.socket));
    answer.on("close", () => outgoing.destroy());
    incoming.pipe(outgoing);
  });

  server.on("upgrade", (incoming: IncomingMessage, socket: Socket, head: Buffer) => {
    if (proxy.mode === "blocked") return void socket.destroy();
    if (proxy.mode === "buffering") return void socket.end("HTTP/1.1 200 OK\r\n\r\nNot here.");
    const upstream = connect(Number(target.port), target.hostname);
    for (const end of [socket, upstream]) {
      sockets.add(end);
      end.on("error", () => undefined);
    }
    socket.on("close", () => upstream.destroy());
    upstream.on("close", () => socket.destroy());
    const headers = Object.entries(incoming.headers).filter(
      ([name]) => proxy.mode !== "stripped" || (name !== "upgrade" && name !== "connection"),
    );
    const lines = headers.map(([name, value]) => `${name}: ${String(value)}`);
    upstream.write(`GET ${incoming.url} HTTP/1.1\r\n${lines.join("\r\n")}\r\n\r\n`);
    upstream.write(head);
    if (proxy.mode === "silent") {
      upstream.once("data", (data: Buffer) => socket.write(data));
      return undefined;
    }
    if (proxy.mode !== "stripped") proxy.upgrades += 1;
    if (proxy.mode === "cut early") setTimeout(() => cutLate(socket), timeoutMs).unref();
    if (proxy.mode === "impatient") socket.setTimeout(timeoutMs, () => cutLate(socket));
    socket.pipe(upstream);
    return void upstream.pipe(socket);
  });

  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  proxy.origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  return proxy;
}

/** The headers without those of the connection. */
function headersFor({ headers }: IncomingMessage): Record<string, string | string[]> {
  const { connection: _connection, upgrade: _upgrade, host: _host, ...rest } = headers;
  return rest as Record<string, string | string[]>;
}
