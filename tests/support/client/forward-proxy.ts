import { once } from "node:events";
import { createServer, request } from "node:http";
import { connect, type AddressInfo, type Socket } from "node:net";
import { onTestFinished } from "vitest";

const NAME = "robots.invalid";

/** An obligatory proxy: only the proxy can resolve the name of the service. */
export interface ForwardProxy {
  /** origin of the service through the proxy */
  readonly service: string;
  /** environment variables that configure the proxy in each language */
  readonly env: Record<string, string>;
  /** number of forwarded requests and opened tunnels */
  readonly forwarded: number;
}

/** Starts a proxy; it stops with the test. @param target origin of the service */
export async function startForwardProxy(target: string): Promise<ForwardProxy> {
  const { hostname, port } = new URL(target);
  const sockets = new Set<Socket>();
  let forwarded = 0;
  const proxy = createServer((incoming, outgoing) => {
    const { host, pathname, search } = new URL(incoming.url ?? "", target);
    if (host !== NAME) return void outgoing.writeHead(502).end();
    forwarded += 1;
    const { method, headers } = incoming;
    const options = { hostname, port, path: pathname + search, method, headers };
    const sent = request(options, (response) => {
      outgoing.writeHead(response.statusCode ?? 502, response.headers);
      response.pipe(outgoing);
    });
    sent.on("error", () => outgoing.destroy());
    incoming.pipe(sent);
  });
  proxy.on("connect", (incoming, client: Socket, head: Buffer) => {
    if (incoming.url !== `${NAME}:80`) return void client.end("HTTP/1.1 502 Bad Gateway\r\n\r\n");
    forwarded += 1;
    const service = connect(Number(port), hostname);
    for (const [from, to] of [
      [client, service],
      [service, client],
    ] as const) {
      sockets.add(from);
      from.on("error", () => to.destroy());
      from.on("close", () => sockets.delete(from));
    }
    client.write("HTTP/1.1 200 Connection Established\r\n\r\n");
    service.write(head);
    client.pipe(service).pipe(client);
  });
  proxy.listen(0, "127.0.0.1");
  await once(proxy, "listening");
  onTestFinished(() => {
    proxy.close();
    proxy.closeAllConnections();
    for (const socket of sockets) socket.destroy();
  });
  const { port: own } = proxy.address() as AddressInfo;
  return {
    service: `http://${NAME}`,
    env: {
      http_proxy: `http://127.0.0.1:${own}`,
      no_proxy: "",
      // Node and Java use the proxy only with these variables.
      NODE_USE_ENV_PROXY: "1",
      JAVA_TOOL_OPTIONS: `-Dhttp.proxyHost=127.0.0.1 -Dhttp.proxyPort=${own}`,
    },
    get forwarded() {
      return forwarded;
    },
  };
}
