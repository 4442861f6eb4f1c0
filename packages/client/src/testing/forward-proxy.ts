/** The proxy of a school's network: a service outside is reached by it alone, under a name that nobody else knows. */
import { once } from "node:events";
import { createServer, request } from "node:http";
import { connect, type AddressInfo, type Socket } from "node:net";
import { onTestFinished } from "vitest";

const NAME = "robots.invalid";

export interface ForwardProxy {
  /** by which the service is known behind the proxy */
  readonly service: string;
  /** settings of the environment that lead to the proxy, as each language reads them */
  readonly env: Record<string, string>;
  /** requests that were passed on, and tunnels that were opened */
  readonly passed: number;
}

/** Starts one; it ends with the test. @param target origin of the service */
export async function startForwardProxy(target: string): Promise<ForwardProxy> {
  const { hostname, port } = new URL(target);
  const sockets = new Set<Socket>();
  let passed = 0;
  const proxy = createServer((asked, answer) => {
    const { host, pathname, search } = new URL(asked.url ?? "", target);
    if (host !== NAME) return void answer.writeHead(502).end();
    passed += 1;
    const { method, headers } = asked;
    const ask = request({ hostname, port, path: pathname + search, method, headers }, (got) => {
      answer.writeHead(got.statusCode ?? 502, got.headers);
      got.pipe(answer);
    });
    ask.on("error", () => answer.destroy());
    asked.pipe(ask);
  });
  proxy.on("connect", (asked, client: Socket, head: Buffer) => {
    if (asked.url !== `${NAME}:80`) return void client.end("HTTP/1.1 502 Bad Gateway\r\n\r\n");
    passed += 1;
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
      // Node and Java look there only where they are told to.
      NODE_USE_ENV_PROXY: "1",
      JAVA_TOOL_OPTIONS: `-Dhttp.proxyHost=127.0.0.1 -Dhttp.proxyPort=${own}`,
    },
    get passed() {
      return passed;
    },
  };
}
