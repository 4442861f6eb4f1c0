/**
 * A `ws` socket that says in words why it ends. What breaks the WebSocket protocol itself is refused by the
 * library, which closes with a code alone: nothing that somebody who wrote the client could act on.
 */
import { WebSocket } from "ws";

const reasons = new Map([
  [1002, "The frames are no WebSocket frames. Let a library make them, and send JSON text."],
  [1007, "The text is not UTF-8. Encode each message as UTF-8, then send it again."],
  [1009, "The message is too large. Send at most 16 KiB in one."],
]);

export class SpeakingSocket extends WebSocket {
  override close(code?: number, reason?: string | Buffer): void {
    super.close(code, reason ?? reasons.get(code ?? 0));
  }
}
