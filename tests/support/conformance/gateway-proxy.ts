/** A proxy in front of a relay's gateways, which injects a fault into their messages. */
import { createServer, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { WebSocket, WebSocketServer } from "ws";

export interface HttpMessage {
  status: number;
  headers: Record<string, string>;
  text: string;
}

export interface GatewayFault {
  /** changes the body of a request to a gateway */
  request?: (text: string) => string;
  /** changes an answer of a gateway to a request of this method */
  response?: (answer: HttpMessage, method: string) => HttpMessage;
  /** changes a frame of a ROS client; null drops it */
  fromClient?: (frame: string) => string | null;
  /** changes a frame to a ROS client */
  toClient?: (frame: string) => string;
  /** sent to each ROS client that connects */
  greeting?: string;
  /** connects ROS clients without their key */
  dropsKey?: boolean;
  /** opens each WebSocket, and closes it with 4401 if the relay refuses the upgrade */
  opensFirst?: boolean;
}

export interface GatewayProxy {
  origin: string;
  close: () => void;
}

export async function openGatewayProxy(relay: string, fault: GatewayFault): Promise<GatewayProxy> {
  const server = createServer((incoming, response) => {
    forward(relay, fault, incoming, response).catch(() => response.destroy());
  });
  const sockets = new WebSocketServer({ noServer: true });
  server.on("upgrade", (incoming, socket, head) => {
    const { url = "", headers } = incoming;
    const { authorization } = headers;
    const upstream = new WebSocket(relay.replace("http", "ws") + url, {
      headers: authorization === undefined || fault.dropsKey ? {} : { authorization },
    });
    const open = (): void =>
      sockets.handleUpgrade(incoming, socket, head, (client) => join(client, upstream, fault));
    if (fault.opensFirst === true) return open();
    upstream.once("open", open);
    upstream.once("unexpected-response", (_request, { statusCode }) => {
      socket.end(`HTTP/1.1 ${statusCode} Refused\r\nContent-Length: 0\r\n\r\n`);
    });
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address() as AddressInfo;
  const close = (): void => {
    for (const client of sockets.clients) client.terminate();
    server.closeAllConnections();
    server.close();
  };
  return { origin: `http://127.0.0.1:${port}`, close };
}

function join(client: WebSocket, upstream: WebSocket, fault: GatewayFault): void {
  if (fault.greeting !== undefined) client.send(fault.greeting);
  client.on("message", (data: Buffer) => {
    const frame = (fault.fromClient ?? String)(data.toString());
    if (frame !== null) upstream.send(frame);
  });
  upstream.on("message", (data: Buffer) =>
    client.send((fault.toClient ?? String)(data.toString())),
  );
  upstream.on("error", () => client.close(4401));
  upstream.on("close", (code) => client.close(code === 1006 ? 4401 : code));
  client.on("close", () => upstream.close());
}

async function forward(
  relay: string,
  fault: GatewayFault,
  incoming: IncomingMessage,
  response: ServerResponse,
): Promise<void> {
  const { method = "GET", url = "" } = incoming;
  const chunks: Buffer[] = [];
  for await (const chunk of incoming) chunks.push(chunk as Buffer);
  const isGateway = !url.startsWith("/api/");
  const text = Buffer.concat(chunks).toString();
  const {
    host: _host,
    connection: _connection,
    "content-length": _length,
    ...headers
  } = incoming.headers;
  const answer = await fetch(relay + url, {
    method,
    headers: headers as Record<string, string>,
    ...(method !== "GET" && { body: isGateway ? (fault.request ?? String)(text) : text }),
  });
  const original: HttpMessage = {
    status: answer.status,
    headers: Object.fromEntries(answer.headers),
    // The relay writes its own origin into the WSDL.
    text: (await answer.text()).replaceAll(relay, `http://${incoming.headers.host}`),
  };
  const changed = isGateway ? (fault.response?.(original, method) ?? original) : original;
  for (const name of ["content-length", "content-encoding", "transfer-encoding", "connection"]) {
    delete changed.headers[name];
  }
  response.writeHead(changed.status, changed.headers).end(changed.text);
}
