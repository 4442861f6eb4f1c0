/**
 * What clients take from this machine, with the doors that a row leaves open and an ear on what is
 * said.
 */
import { fetchedMessagesSchema, readJson, type SocketEvents } from "@corridor/protocol";
import { globalPlatform, type Platform } from "../../packages/client/src/platform.ts";
import type { Doors } from "./robots/page-messages.ts";

const MAX_ANSWER = 1024 * 1024;
const nothing = (): void => undefined;

/** Hears each message of a client as it is sent for the first time or again, and as it comes. */
export type Ear = (direction: "up" | "down", text: string) => void;

export function platformWith(doors: Doors): Platform {
  const { ask, ...rest } = globalPlatform();
  if (doors === "websocket" || ask === undefined) return rest;
  if (doors === "both") return { ...rest, ask };
  return { ...rest, ask, connect: (_url, events) => closedDoor(events) };
}

/** The same platform; all messages are heard, by WebSocket and by HTTPS. */
export function overheard(platform: Platform, ear: Ear): Platform {
  const { connect, ask } = platform;
  return {
    ...platform,
    connect: (url, events) => {
      const socket = connect(url, {
        ...events,
        opened: () => events.opened(),
        closed: (code) => events.closed(code),
        received: (text) => {
          ear("down", text);
          events.received(text);
        },
      });
      return {
        send: (text) => {
          ear("up", text);
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
    ...(ask !== undefined && {
      ask: (request) => {
        if (request.body !== null) hearBatch(request.body, ear);
        const asked = ask(request);
        const answer = asked.answer.then((got) => {
          const fetched = readJson(fetchedMessagesSchema, got.body, MAX_ANSWER);
          if (fetched.ok) {
            for (const message of fetched.value.messages) ear("down", JSON.stringify(message));
          }
          return got;
        });
        return { answer, cancel: () => asked.cancel() };
      },
    }),
  };
}

function hearBatch(body: string, ear: Ear): void {
  const { messages } = JSON.parse(body) as { messages?: unknown[] };
  for (const message of messages ?? []) ear("up", JSON.stringify(message));
}

/** A net that lets no WebSocket through. */
function closedDoor(events: SocketEvents) {
  setTimeout(() => events.closed(1006), 1);
  return { send: nothing, close: nothing, isOpen: false, waitingBytes: 0 };
}
