/**
 * Platforms for clients on this machine, restricted to some transports, and with a listener for all
 * messages.
 */
import { fetchedMessagesSchema, readJson, type SocketEvents } from "@corridor/protocol";
import { globalPlatform, type Platform } from "../../packages/client/src/platform.ts";
import type { Transports } from "./robots/page-messages.ts";

const MAX_RESPONSE = 1024 * 1024;
const noop = (): void => undefined;

/**
 * Receives each message of a client whenever it is sent, including retries, and whenever one
 * arrives.
 */
export type MessageListener = (direction: "up" | "down", text: string) => void;

export function platformFor(transports: Transports): Platform {
  const { request, ...rest } = globalPlatform();
  if (transports === "websocket" || request === undefined) return rest;
  if (transports === "both") return { ...rest, request };
  return { ...rest, request, connect: (_url, events) => blockedWebSocket(events) };
}

/** The same platform with a listener for all messages, by WebSocket and by HTTPS. */
export function withListener(platform: Platform, listener: MessageListener): Platform {
  const { connect, request } = platform;
  return {
    ...platform,
    connect: (url, events) => {
      const socket = connect(url, {
        ...events,
        opened: () => events.opened(),
        closed: (code) => events.closed(code),
        received: (text) => {
          listener("down", text);
          events.received(text);
        },
      });
      return {
        send: (text) => {
          listener("up", text);
          socket.send(text);
        },
        close: (code, reason) => socket.close(code, reason),
        get isOpen() {
          return socket.isOpen;
        },
        get waitingBytes() {
          return socket.waitingBytes;
        },
      };
    },
    ...(request !== undefined && {
      request: (sent) => {
        if (sent.body !== null) reportBatch(sent.body, listener);
        const pending = request(sent);
        const response = pending.response.then((received) => {
          const fetched = readJson(fetchedMessagesSchema, received.body, MAX_RESPONSE);
          if (fetched.ok) {
            for (const message of fetched.value.messages) listener("down", JSON.stringify(message));
          }
          return received;
        });
        return { response, cancel: () => pending.cancel() };
      },
    }),
  };
}

function reportBatch(body: string, listener: MessageListener): void {
  const { messages } = JSON.parse(body) as { messages?: unknown[] };
  for (const message of messages ?? []) listener("up", JSON.stringify(message));
}

/** A WebSocket that a network blocks. */
function blockedWebSocket(events: SocketEvents) {
  setTimeout(() => events.closed(1006), 1);
  return { send: noop, close: noop, isOpen: false, waitingBytes: 0 };
}
