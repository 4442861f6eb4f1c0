/**
 * socket.io as in its guide: one room for a robot's page and one for its reader. Messages are
 * objects, without storage or validation.
 */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { Server } from "socket.io";

const server = createServer();
const io = new Server(server, { transports: ["websocket"] });

io.on("connection", (socket) => {
  const { robot, role } = socket.handshake.auth as { robot: string; role: "page" | "reader" };
  const other = `${robot}/${role === "page" ? "reader" : "page"}`;
  void socket.join(`${robot}/${role}`);
  for (const event of ["snapshot", "command", "answer"]) {
    socket.on(event, (message: unknown) => io.to(other).emit(event, message));
  }
});
server.listen(0, "127.0.0.1", () => {
  console.log(`ready ${(server.address() as AddressInfo).port}`);
});
