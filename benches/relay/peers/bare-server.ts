/**
 * The baseline: forwards the bytes of each message unchanged between a robot's page and its reader.
 * Lower bound of the cost: no parsing, no authorisation, no storage.
 */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { WebSocketServer, type WebSocket } from "ws";

const server = createServer();
const sockets = new WebSocketServer({ server, perMessageDeflate: false });
/** Sockets by path: /ROBOT/page and /ROBOT/reader. */
const ends = new Map<string, WebSocket>();

sockets.on("connection", (socket, request) => {
  const path = request.url ?? "";
  const other = path.endsWith("/page")
    ? path.replace(/page$/, "reader")
    : path.replace(/reader$/, "page");
  ends.set(path, socket);
  socket.on("message", (data: Buffer, binary) => ends.get(other)?.send(data, { binary }));
  socket.on("close", () => ends.delete(path));
});
server.listen(0, "127.0.0.1", () => {
  console.log(`ready ${(server.address() as AddressInfo).port}`);
});
