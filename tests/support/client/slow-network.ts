import type { SocketPort } from "@corridor/protocol";
import { globalPlatform, type Platform } from "../../../packages/client/src/platform.ts";

export interface SlowNetwork {
  platform: Platform;
  /** numbers of received and sent messages by type */
  received: Map<string, number>;
  sent: Map<string, number>;
}

/** A platform that delays all messages of its WebSockets. @param delayMs in each direction */
export function slowNetwork(delayMs: number): SlowNetwork {
  const platform = globalPlatform();
  const received = new Map<string, number>();
  const sent = new Map<string, number>();
  const connect: Platform["connect"] = (url, events) => {
    const later = (call: () => void): void => void platform.clock.after(delayMs, call);
    const socket: SocketPort = platform.connect(url, {
      ...events,
      received: (text) =>
        later(() => {
          count(received, text);
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
  return { platform: { ...platform, connect }, received, sent };
}

function count(counts: Map<string, number>, text: string): void {
  const { type } = JSON.parse(text) as { type: string };
  counts.set(type, (counts.get(type) ?? 0) + 1);
}
