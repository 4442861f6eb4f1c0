/** What may stand between a school and a relay: a proxy that forwards requests and does harm to some. */
import { createServer, request, type IncomingMessage } from "node:http";
import { connect, type AddressInfo, type Socket } from "node:net";
import type { Duplex } from "node:stream";

export type Harm =
  /** none: everything passes */
  | "none"
  /** the header Upgrade is taken off, so that the relay sees an ordinary request */
  | "stripped"
  /** upgrades are cut off */
  | "blocked"
  /** an upgrade is answered, and then nothing passes */
  | "silent"
  /** a WebSocket is cut a moment after it was opened */
  | "cut early"
  /** what is silent for a moment is cut: sockets and requests that wait */
  | "impatient"
  /** answers are kept back until they have ended; upgrades are answered with a page of words */
  | "buffering";

export interface FilterProxy {
  origin: string;
  harm: Harm;
  /** WebSockets that were opened through it */
  upgrades: number;
  /** requests that were made through it */
  requests: number;
  close(): void;
}

/**
 * Starts a proxy in front of a relay.
 * @param momentMs after which it cuts what is early or silent
 */
export async function openFilterProxy(
  relay: string,
  harm: Harm,
  momentMs: number,
): Promise<FilterProxy> {
  const target = new URL(relay);
  const close = (): void => {
    for (const socket of sockets) socket.destroy();
    server.closeAllConnections();
    server.close();
  };
  const proxy: FilterProxy = { origin: "", harm, upgrades: 0, requests: 0, close };
  const sockets = new Set<Duplex>();

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
        if (proxy.harm === "buffering") {
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
    if (proxy.harm === "impatient") outgoing.setTimeout(momentMs, cut);
    answer.on("close", () => outgoing.destroy());
    incoming.pipe(outgoing);
  });

  server.on("upgrade", (incoming: IncomingMessage, socket: Socket, head: Buffer) => {
    if (proxy.harm === "blocked") return void socket.destroy();
    if (proxy.harm === "buffering") return void socket.end("HTTP/1.1 200 OK\r\n\r\nNot here.");
    const upstream = connect(Number(target.port), target.hostname);
    for (const end of [socket, upstream]) {
      sockets.add(end);
      end.on("error", () => undefined);
    }
    socket.on("close", () => upstream.destroy());
    upstream.on("close", () => socket.destroy());
    const headers = Object.entries(incoming.headers).filter(
      ([name]) => proxy.harm !== "stripped" || (name !== "upgrade" && name !== "connection"),
    );
    const lines = headers.map(([name, value]) => `${name}: ${String(value)}`);
    upstream.write(`GET ${incoming.url} HTTP/1.1\r\n${lines.join("\r\n")}\r\n\r\n`);
    upstream.write(head);
    if (proxy.harm === "silent") {
      upstream.once("data", (data: Buffer) => socket.write(data));
      return undefined;
    }
    if (proxy.harm !== "stripped") proxy.upgrades += 1;
    if (proxy.harm === "cut early") setTimeout(() => socket.destroy(), momentMs).unref();
    if (proxy.harm === "impatient") socket.setTimeout(momentMs, () => socket.destroy());
    socket.pipe(upstream);
    return void upstream.pipe(socket);
  });

  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  proxy.origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  return proxy;
}

/** The headers as they came, but those of the one connection. */
function headersFor({ headers }: IncomingMessage): Record<string, string | string[]> {
  const { connection: _connection, upgrade: _upgrade, host: _host, ...rest } = headers;
  return rest as Record<string, string | string[]>;
}
