/**
 * The smallest balancer that will do for trying out several relays: each request goes to the next relay
 * that takes it, those of a line by HTTPS to one relay for each robot, because a line lives there. In
 * earnest use nginx, HAProxy or a cloud's.
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
const LINE = /^\/api\/v1\/robots\/([^/?]+)\/line(?:[/?]|$)/;
/** of one connection, not of the message; what the body needs Node adds again */
const HOP = new Set(["connection", "keep-alive", "transfer-encoding"]);

export interface Balancer {
  port: number;
  /** where requests may go; may change at any time */
  targets: number[];
  close(): Promise<void>;
}

/**
 * Starts a balancer.
 * @param targets ports of this machine
 * @param port 0: any free one
 * @param host to listen on; undefined: every address
 */
export async function startBalancer(targets: number[], port = 0, host?: string): Promise<Balancer> {
  const balancer = { port, targets, close: () => close() };
  const open = new Set<Socket>();
  let turn = 0;
  const orderFor = (url = ""): number[] => {
    const robot = LINE.exec(url)?.[1];
    if (robot !== undefined) return byRobot(robot, balancer.targets);
    const first = turn++ % Math.max(1, balancer.targets.length);
    return [...balancer.targets.slice(first), ...balancer.targets.slice(0, first)];
  };
  const server = createServer((request, response) => {
    void pass(request, response, orderFor(request.url));
  });
  server.on("connection", (client: Socket) => {
    open.add(client);
    client.on("close", () => open.delete(client));
    client.on("error", () => client.destroy());
  });
  server.on("upgrade", (request, client, head) => {
    void join(request, client, head, orderFor(request.url));
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

/** The order in which relays are tried for a robot: the same as long as they are, and little else when one goes. */
function byRobot(robot: string, ports: number[]): number[] {
  const rank = (port: number): string =>
    createHash("sha1").update(`${robot} ${port}`).digest("hex");
  return ports.toSorted((a, b) => (rank(a) < rank(b) ? -1 : 1));
}

/** Passes a request on, and its answer back as it comes. A relay that breaks off cuts its client. */
async function pass(
  request: IncomingMessage,
  response: ServerResponse,
  ports: number[],
): Promise<void> {
  const relay = await firstOf(ports);
  if (relay === null) return void response.destroy();
  const { method, url, rawHeaders } = request;
  const onward = forward({
    createConnection: () => relay,
    method,
    path: url,
    headers: withoutHops(rawHeaders),
    setHost: false,
  });
  onward.on("error", () => response.destroy());
  onward.on("response", (answer) => {
    response.writeHead(answer.statusCode ?? 502, withoutHops(answer.rawHeaders));
    response.flushHeaders();
    pipeline(answer, response, () => undefined);
  });
  response.on("close", () => onward.destroy());
  request.pipe(onward);
}

/** Joins a client that wants another protocol with a relay, byte by byte. */
async function join(
  { method, url, rawHeaders }: IncomingMessage,
  client: Duplex,
  head: Buffer,
  ports: number[],
): Promise<void> {
  const relay = await firstOf(ports);
  if (relay === null) return void client.destroy();
  relay.on("error", () => client.destroy());
  relay.on("close", () => client.destroy());
  client.on("error", () => relay.destroy());
  client.on("close", () => relay.destroy());
  const lines = pairsOf(rawHeaders).map(([name, value]) => `${name}: ${value}\r\n`);
  relay.write(`${method} ${url} HTTP/1.1\r\n${lines.join("")}\r\n`);
  relay.write(head);
  client.pipe(relay).pipe(client);
}

function withoutHops(rawHeaders: string[]): string[] {
  return pairsOf(rawHeaders)
    .filter(([name]) => !HOP.has(name.toLowerCase()))
    .flat();
}

function pairsOf(rawHeaders: string[]): [string, string][] {
  return rawHeaders.flatMap((name, index) =>
    index % 2 === 0 ? [[name, rawHeaders[index + 1] ?? ""] as [string, string]] : [],
  );
}

/** A connection to the first relay that takes it. */
async function firstOf(ports: number[]): Promise<Socket | null> {
  for (const port of ports) {
    const relay = await reach(port);
    if (relay !== null) return relay;
  }
  return null;
}

function reach(port: number): Promise<Socket | null> {
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
