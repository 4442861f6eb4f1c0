/**
 * A `ws` socket that closes with a textual reason. On protocol errors the library closes with a
 * code only, which does not help the author of a client.
 */
import { WebSocket } from "ws";

const reasons = new Map([
  [1002, "Invalid WebSocket frames. Use a WebSocket library, and send JSON text."],
  [1007, "The text is not valid UTF-8. Encode each message as UTF-8."],
  [1009, "The message is too large. Send at most 16 KiB in one message."],
]);

export class SocketWithReasons extends WebSocket {
  override close(code?: number, reason?: string | Buffer): void {
    super.close(code, reason ?? reasons.get(code ?? 0));
  }
}
