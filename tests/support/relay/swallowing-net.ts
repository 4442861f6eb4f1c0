/** A network that drops all data silently: connections stay open on both sides. */
import { connect, createServer, type AddressInfo, type Socket } from "node:net";
import { onTestFinished } from "vitest";

/** A proxy to a local port. `swallow` keeps open connections open, but drops their data. */
export async function swallowingNet(port: number) {
  const pairs = new Set<[Socket, Socket]>();
  const server = createServer((client) => {
    const target = connect(port, "127.0.0.1");
    pairs.add([client, target]);
    for (const socket of [client, target]) socket.on("error", () => undefined);
    client.pipe(target).pipe(client);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  onTestFinished(() => {
    for (const pair of pairs) for (const socket of pair) socket.destroy();
    server.close();
  });
  return {
    url: `redis://127.0.0.1:${(server.address() as AddressInfo).port}`,
    swallow: () => {
      for (const [client, target] of pairs) {
        client.unpipe(target);
        target.unpipe(client);
        for (const socket of [client, target]) socket.on("data", () => undefined);
      }
    },
  };
}
