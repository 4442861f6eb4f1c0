/**
 * A minimal load balancer for trying out several relays on one machine. It distributes requests
 * round-robin. Requests of the long-poll connections of a robot or a class always reach the same
 * relay, because that relay holds the connection's state. In production, use nginx, HAProxy or a
 * cloud load balancer.
 */
import { createHash } from "node:crypto";
import { createServer } from "node:http";
import { connect, type AddressInfo, type Socket } from "node:net";
import { createProxyServer } from "http-proxy-3";

const CONNECT_MS = 1_000;
const LONG_POLL_PATH = /^\/api\/v1\/(?:robots|classes)\/([^/?]+)\/long-poll(?:[/?]|$)/;

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
    const id = LONG_POLL_PATH.exec(url)?.[1];
    if (id !== undefined) return rankedFor(id, balancer.targets);
    const first = nextIndex++ % Math.max(1, balancer.targets.length);
    return [...balancer.targets.slice(first), ...balancer.targets.slice(0, first)];
  };
  const proxy = createProxyServer();
  const server = createServer((request, response) => {
    void reachable(orderFor(request.url)).then((target) => {
      if (target === null) return response.destroy();
      // A relay that disconnects disconnects the client.
      return proxy.web(request, response, { target }, () => response.destroy());
    });
  });
  server.on("connection", (client: Socket) => {
    open.add(client);
    client.on("close", () => open.delete(client));
    client.on("error", () => client.destroy());
  });
  server.on("upgrade", (request, client: Socket, head) => {
    void reachable(orderFor(request.url)).then((target) => {
      if (target === null) return client.destroy();
      return proxy.ws(request, client, head, { target }, () => client.destroy());
    });
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
 * The order in which relays are tried for a robot or a class (rendezvous hashing). It is stable
 * while the relays are the same. When a relay leaves, only the robots and classes of that relay
 * move.
 */
function rankedFor(id: string, ports: number[]): number[] {
  const rank = (port: number): string => createHash("sha1").update(`${id} ${port}`).digest("hex");
  return ports.toSorted((a, b) => (rank(a) < rank(b) ? -1 : 1));
}

/** The address of the first relay that accepts connections. @returns null if none does */
async function reachable(ports: number[]): Promise<string | null> {
  for (const port of ports) if (await accepts(port)) return `http://127.0.0.1:${port}`;
  return null;
}

function accepts(port: number): Promise<boolean> {
  return new Promise((resolve) => {
    const socket = connect({ port, host: "127.0.0.1" });
    const end = (isOpen: boolean): void => {
      socket.destroy();
      resolve(isOpen);
    };
    socket.setTimeout(CONNECT_MS, () => end(false));
    socket.once("error", () => end(false));
    socket.once("connect", () => end(true));
  });
}
