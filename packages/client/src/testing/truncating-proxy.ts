/** A stretch of network that loses the end of some answers: their status says that all is well. */
import { once } from "node:events";
import { connect, createServer, type AddressInfo, type Socket } from "node:net";
import { onTestFinished } from "vitest";

/** So many bytes at the end of an answer never come. */
const LOST_BYTES = 10;

export interface CuttingProxy {
  origin: string;
  /** how many answers were cut */
  readonly cuts: number;
}

/**
 * Starts one; it ends with the test.
 * @param target origin of the service
 * @param every so many answers the next one is cut
 */
export async function startCuttingProxy(target: string, every: number): Promise<CuttingProxy> {
  const { hostname, port } = new URL(target);
  const sockets = new Set<Socket>();
  let answers = 0;
  let cuts = 0;
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
      answers += 1;
      const isCut = answers % every === 0 && data.toString("latin1").startsWith("HTTP/1.1 2");
      if (!isCut) return void client.write(data);
      cuts += 1;
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
    get cuts() {
      return cuts;
    },
  };
}
