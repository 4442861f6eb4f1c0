/**
 * A `ws` socket as the smallest socket that the rest of the relay needs. Every message goes through
 * here, so that none, however it came about, can pile up for somebody who does not read. (Pongs have
 * a limit of their own in `ws`.)
 *
 * What the other side has taken is found out by pings: its WebSocket library answers each one by
 * itself, after all that came before.
 */
import { closeReasons } from "@corridor/protocol";
import type { WebSocket } from "ws";
import type { Clock } from "../clock.ts";
import { limits } from "../sessions/limits.ts";
import { closeWith } from "./conversation.ts";
import type { ReaderLine } from "./reader-line.ts";

/** @param clock counts the time that a goodbye may take */
export function wsPort(socket: WebSocket, clock: Clock): ReaderLine {
  let sentBytes = 0;
  let takenBytes = 0;
  /** what was sent before the ping that is not answered yet */
  let asked: number | null = null;
  let asksAgain = false;
  const flow = {
    get sentBytes() {
      return sentBytes;
    },
    get takenBytes() {
      return takenBytes;
    },
    isProof: true,
    ask: () => {
      asksAgain = asked !== null;
      if (asksAgain || !port.isOpen) return;
      asked = sentBytes;
      socket.ping(String(asked));
    },
  };
  socket.on("pong", (data: Buffer) => {
    if (asked === null || data.toString() !== String(asked)) return;
    takenBytes = asked;
    asked = null;
    if (asksAgain) flow.ask();
  });
  const port: ReaderLine = {
    door: "websocket",
    flow,
    send: (text) => {
      if (!port.isOpen) return;
      if (port.waitingBytes > limits.stuckReaderBytes) return closeWith(port, closeReasons.tooSlow);
      sentBytes += text.length;
      socket.send(text);
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
