/** A `ws` socket as the smallest socket that the rest of the relay needs. */
import type { SocketPort } from "@corridor/protocol";
import type { WebSocket } from "ws";

export function wsPort(socket: WebSocket): SocketPort {
  return {
    send: (text) => {
      if (socket.readyState === socket.OPEN) socket.send(text);
    },
    close: (code, reason) => socket.close(code, reason),
    get isOpen() {
      return socket.readyState === socket.OPEN;
    },
    get waitingBytes() {
      return socket.bufferedAmount;
    },
  };
}
