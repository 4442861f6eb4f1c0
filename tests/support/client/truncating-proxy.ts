/** A proxy that truncates some responses; their status still reports success. */
import { once } from "node:events";
import { connect, createServer, type AddressInfo, type Socket } from "node:net";
import { onTestFinished } from "vitest";

/** Number of bytes that are missing at the end. */
const LOST_BYTES = 10;

export interface TruncatingProxy {
  origin: string;
  /** number of truncated responses */
  readonly truncated: number;
}

/**
 * Starts a proxy; it stops with the test.
 * @param target origin of the service
 * @param every interval of truncated responses
 */
export async function startTruncatingProxy(
  target: string,
  every: number,
): Promise<TruncatingProxy> {
  const { hostname, port } = new URL(target);
  const sockets = new Set<Socket>();
  let responses = 0;
  let truncated = 0;
  const proxy = createServer((client) => {
    const service = connect(Number(port), hostname);
    for (const socket of [client, service]) {
      sockets.add(socket);
      socket.on("error", () => undefined);
      socket.on("close", () => sockets.delete(socket));
    }
    client.pipe(service);
    client.on("close", () => service.destroy());
    service.on("end", () => client.end());
    service.on("data", (data: Buffer) => {
      responses += 1;
      const isTruncated =
        responses % every === 0 && data.toString("latin1").startsWith("HTTP/1.1 2");
      if (!isTruncated) return void client.write(data);
      truncated += 1;
      client.end(data.subarray(0, -LOST_BYTES));
      service.destroy();
    });
  });
  proxy.listen(0, "127.0.0.1");
  await once(proxy, "listening");
  onTestFinished(() => {
    proxy.close();
    for (const socket of sockets) socket.destroy();
  });
  return {
    origin: `http://127.0.0.1:${(proxy.address() as AddressInfo).port}`,
    get truncated() {
      return truncated;
    },
  };
}
