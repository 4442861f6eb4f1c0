import {
  decodeFrame,
  encodeFrame,
  PROTOCOL_VERSION,
  relayToStudentSchema,
  type RelayToStudent,
  type StudentToRelay,
} from "@corridor/protocol";
import { Connection, type ConnectionStatus } from "./connection.ts";
import { connectionUrls } from "./connection-urls.ts";
import { globalPlatform, type Platform } from "./platform.ts";

/** A message for the student. */
export type ClassMessage = Exclude<RelayToStudent, { type: "heartbeat" }>;

export interface LearnLinkOptions {
  /** of the service, such as https://robots.example.org */
  origin: string;
  /** of the class */
  id: string;
  /** a student's key */
  key: string;
  /** Called for the welcome of each connection before `onStatus`. */
  onMessage: (message: ClassMessage) => void;
  /** The close code of `over` says why the student is no longer in the class on this page. */
  onStatus: (status: ConnectionStatus) => void;
  /** default: the platform of browsers, workers and Node */
  platform?: Omit<Platform, "uniqueText">;
}

/** A student's connection to a class. It can run in a worker. */
export class LearnLink {
  readonly #connection: Connection<RelayToStudent>;

  /** Connects at once. */
  constructor(options: LearnLinkOptions) {
    const { origin, id, key, onMessage, onStatus, platform = globalPlatform() } = options;
    this.#connection = new Connection({
      urls: connectionUrls(origin, "classes", id),
      platform,
      firstMessages: () => [
        encodeFrame({ type: "hello", version: PROTOCOL_VERSION, role: "learn", key }),
      ],
      decode: (text) => decodeFrame(relayToStudentSchema, text),
      received: (message) => {
        if (message.type !== "heartbeat") onMessage(message);
      },
      changed: onStatus,
    });
    this.#connection.open();
  }

  /** Whether the relay has sent its welcome on the current connection. */
  get isConnected(): boolean {
    return this.#connection.isConnected;
  }

  /** Reconnects at once instead of waiting for the next attempt. */
  open(): void {
    this.#connection.open();
  }

  /** Sends a message; drops it while there is no connection. */
  send(message: StudentToRelay): void {
    this.#connection.send(encodeFrame(message));
  }

  close(): void {
    this.#connection.close();
  }
}
