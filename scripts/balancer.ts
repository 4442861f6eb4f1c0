/**
 * The smallest balancer that will do for trying out several relays: each connection goes to the next relay
 * that takes it, byte by byte. It knows nothing of HTTP; in earnest use nginx, HAProxy or a cloud's.
 */
import { connect, createServer, type AddressInfo, type Socket } from "node:net";

const CONNECT_MS = 1_000;

export interface Balancer {
  port: number;
  /** where connections may go; may change at any time */
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
  const server = createServer({ pauseOnConnect: true }, (client) => {
    open.add(client);
    client.on("close", () => open.delete(client));
    client.on("error", () => client.destroy());
    const first = turn++;
    const order = balancer.targets.map(
      (_port, index, all) => all[(first + index) % all.length] ?? 0,
    );
    void join(client, order);
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

/** Joins a client with the first relay that takes the connection; with none, it is cut. */
async function join(client: Socket, ports: number[]): Promise<void> {
  for (const port of ports) {
    const relay = await reach(port);
    if (relay === null) continue;
    relay.on("error", () => client.destroy());
    relay.on("close", () => client.destroy());
    client.on("close", () => relay.destroy());
    client.pipe(relay).pipe(client);
    return;
  }
  client.destroy();
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
