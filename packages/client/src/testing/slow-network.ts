/** A platform whose WebSockets lead over a long line: what is said on them arrives so much later. */
import type { SocketPort } from "@corridor/protocol";
import { globalPlatform, type Platform } from "../platform.ts";

export interface LongLine {
  platform: Platform;
  /** messages that came and that were sent, by type */
  came: Map<string, number>;
  sent: Map<string, number>;
}

/** @param wayMs in each direction */
export function longLine(wayMs: number): LongLine {
  const platform = globalPlatform();
  const came = new Map<string, number>();
  const sent = new Map<string, number>();
  const connect: Platform["connect"] = (url, events) => {
    const later = (call: () => void): void => void platform.clock.after(wayMs, call);
    const socket: SocketPort = platform.connect(url, {
      ...events,
      received: (text) =>
        later(() => {
          count(came, text);
          events.received(text);
        }),
    });
    return {
      send: (text) => {
        count(sent, text);
        later(() => socket.send(text));
      },
      close: (code, reason) => socket.close(code, reason),
      get isOpen() {
        return socket.isOpen;
      },
      waitingBytes: 0,
    };
  };
  return { platform: { ...platform, connect }, came, sent };
}

function count(counts: Map<string, number>, text: string): void {
  const { type } = JSON.parse(text) as { type: string };
  counts.set(type, (counts.get(type) ?? 0) + 1);
}
