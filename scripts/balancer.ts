/**
 * A minimal load balancer for trying out several relays on one machine. It distributes requests
 * round-robin. Requests of a robot's long-poll connection always reach the same relay, because that
 * relay holds the connection's state. In production, use nginx, HAProxy or a cloud load balancer.
 */
import { createHash } from "node:crypto";
import {
  createServer,
  request as forward,
  type IncomingMessage,
  type ServerResponse,
} from "node:http";
import { connect, type AddressInfo, type Socket } from "node:net";
import { pipeline, type Duplex } from "node:stream";

const CONNECT_MS = 1_000;
const LONG_POLL_PATH = /^\/api\/v1\/robots\/([^/?]+)\/long-poll(?:[/?]|$)/;
/** Headers that apply to one connection only (RFC 9110, 7.6.1). Node.js sets its own. */
const HOP_BY_HOP_HEADERS = new Set(["connection", "keep-alive", "transfer-encoding"]);

export interface Balancer {
  port: number;
  /** Ports of the relays; may change at any time. */
  targets: number[];
  close(): Promise<void>;
}

/**
 * Starts a balancer.
 * @param targets ports of the relays on this machine
 * @param port the port to listen on; 0 selects a free port
 * @param host the address to listen on; every address if undefined
 */
export async function startBalancer(targets: number[], port = 0, host?: string): Promise<Balancer> {
  const balancer = { port, targets, close: () => close() };
  const open = new Set<Socket>();
  let nextIndex = 0;
  const orderFor = (url = ""): number[] => {
    const robot = LONG_POLL_PATH.exec(url)?.[1];
    if (robot !== undefined) return rankedForRobot(robot, balancer.targets);
    const first = nextIndex++ % Math.max(1, balancer.targets.length);
    return [...balancer.targets.slice(first), ...balancer.targets.slice(0, first)];
  };
  const server = createServer((request, response) => {
    void proxyRequest(request, response, orderFor(request.url));
  });
  server.on("connection", (client: Socket) => {
    open.add(client);
    client.on("close", () => open.delete(client));
    client.on("error", () => client.destroy());
  });
  server.on("upgrade", (request, client, head) => {
    void proxyUpgrade(request, client, head, orderFor(request.url));
  });
  const close = async (): Promise<void> => {
    for (const client of open) client.destroy();
    await new Promise((resolve) => server.close(resolve));
  };
  await new Promise<void>((resolve, reject) => {
    server.once("error", reject);
    server.listen({ port, ...(host !== undefined && { host }) }, resolve);
  });
  balancer.port = (server.address() as AddressInfo).port;
  return balancer;
}

/**
 * The order in which relays are tried for a robot (rendezvous hashing). It is stable while the
 * relays are the same. When a relay leaves, only the robots of that relay move.
 */
function rankedForRobot(robot: string, ports: number[]): number[] {
  const rank = (port: number): string =>
    createHash("sha1").update(`${robot} ${port}`).digest("hex");
  return ports.toSorted((a, b) => (rank(a) < rank(b) ? -1 : 1));
}

/** Proxies a request and streams the response. A relay that disconnects disconnects the client. */
async function proxyRequest(
  request: IncomingMessage,
  response: ServerResponse,
  ports: number[],
): Promise<void> {
  const relay = await connectToFirst(ports);
  if (relay === null) return void response.destroy();
  const { method, url, rawHeaders } = request;
  const upstream = forward({
    createConnection: () => relay,
    method,
    path: url,
    headers: endToEndHeaders(rawHeaders),
    setHost: false,
  });
  upstream.on("error", () => response.destroy());
  upstream.on("response", (upstreamResponse) => {
    const { statusCode, rawHeaders: headers } = upstreamResponse;
    response.writeHead(statusCode ?? 502, endToEndHeaders(headers));
    response.flushHeaders();
    pipeline(upstreamResponse, response, () => undefined);
  });
  response.on("close", () => upstream.destroy());
  request.pipe(upstream);
}

/** Proxies an upgrade request, such as a WebSocket handshake, and then its bytes both ways. */
async function proxyUpgrade(
  { method, url, rawHeaders }: IncomingMessage,
  client: Duplex,
  head: Buffer,
  ports: number[],
): Promise<void> {
  const relay = await connectToFirst(ports);
  if (relay === null) return void client.destroy();
  relay.on("error", () => client.destroy());
  relay.on("close", () => client.destroy());
  client.on("error", () => relay.destroy());
  client.on("close", () => relay.destroy());
  const headers = headerPairs(rawHeaders).map(([name, value]) => `${name}: ${value}\r\n`);
  relay.write(`${method} ${url} HTTP/1.1\r\n${headers.join("")}\r\n`);
  relay.write(head);
  client.pipe(relay).pipe(client);
}

function endToEndHeaders(rawHeaders: string[]): string[] {
  return headerPairs(rawHeaders)
    .filter(([name]) => !HOP_BY_HOP_HEADERS.has(name.toLowerCase()))
    .flat();
}

function headerPairs(rawHeaders: string[]): [string, string][] {
  return rawHeaders.flatMap((name, index) =>
    index % 2 === 0 ? [[name, rawHeaders[index + 1] ?? ""] as [string, string]] : [],
  );
}

/** Connects to the first relay that accepts. @returns null if none does */
async function connectToFirst(ports: number[]): Promise<Socket | null> {
  for (const port of ports) {
    const relay = await connectTo(port);
    if (relay !== null) return relay;
  }
  return null;
}

function connectTo(port: number): Promise<Socket | null> {
  return new Promise((resolve) => {
    const socket = connect({ port, host: "127.0.0.1", noDelay: true });
    const fail = (): void => {
      socket.destroy();
      resolve(null);
    };
    socket.setTimeout(CONNECT_MS, fail);
    socket.once("error", fail);
    socket.once("connect", () => {
      socket.setTimeout(0).off("timeout", fail).off("error", fail);
      resolve(socket);
    });
  });
}
