/**
 * A `ws` socket as the smallest socket that the rest of the relay needs. Every message goes through
 * here, so that none, however it came about, can pile up for somebody who does not read. (Pongs have
 * a limit of their own in `ws`.)
 */
import { closeReasons, type SocketPort } from "@corridor/protocol";
import type { WebSocket } from "ws";
import type { Clock } from "../clock.ts";
import { limits } from "../sessions/limits.ts";
import { closeWith } from "./conversation.ts";

/** @param clock counts the time that a goodbye may take */
export function wsPort(socket: WebSocket, clock: Clock): SocketPort {
  const port: SocketPort = {
    send: (text) => {
      if (!port.isOpen) return;
      if (port.waitingBytes > limits.stuckReaderBytes) closeWith(port, closeReasons.tooSlow);
      else socket.send(text);
    },
    close: (code, reason) => {
      if (!port.isOpen) return;
      socket.close(code, reason);
      // Who does not read does not answer the goodbye either.
      socket.once(
        "close",
        clock.after(limits.goodbyeMs, () => socket.terminate()),
      );
    },
    get isOpen() {
      return socket.readyState === socket.OPEN;
    },
    get waitingBytes() {
      return socket.bufferedAmount;
    },
  };
  return port;
}
