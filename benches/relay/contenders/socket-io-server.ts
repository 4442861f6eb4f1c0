/** socket.io as its guide does it: a room for each end of a robot, messages as objects, nothing stored or checked. */
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
