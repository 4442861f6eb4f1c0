import {
  decodeFrame,
  encodeFrame,
  MAX_FRAME_BYTES,
  PROTOCOL_VERSION,
  type ClassHello,
  type RelayToScreen,
  type RelayToStudent,
  type RelayToTeacher,
  type ScreenToRelay,
  type StudentToRelay,
  type TeacherToRelay,
} from "@corridor/protocol";
import { Connection, type ConnectionStatus } from "./connection.ts";
import { connectionUrls } from "./connection-urls.ts";
import { globalPlatform, type Platform } from "./platform.ts";

export interface ClassConnectionOptions<Message> {
  /** of the service, such as https://robots.example.org */
  origin: string;
  /** of the class */
  id: string;
  /** of the member */
  key: string;
  /** Called for the welcome of each connection before `onStatus`. */
  onMessage: (message: Message) => void;
  /** The close code of `over` says why the member is no longer in the class on this page. */
  onStatus: (status: ConnectionStatus) => void;
  /** default: the platform of browsers, workers and Node */
  platform?: Omit<Platform, "uniqueText">;
}

type FromRelay = RelayToStudent | RelayToTeacher | RelayToScreen;

/** What differs between the kinds of members. */
interface ClassConnectionRole<In extends FromRelay> {
  role: ClassHello["role"];
  schema: Parameters<typeof decodeFrame<In>>[0];
  /** in UTF-16 code units; default: the largest message of a robot */
  maxLength?: number;
  /** the newest event that was received; null: none */
  since?: () => string | null;
}

/** A member's connection to a class. It can run in a worker. */
export class ClassConnection<
  In extends FromRelay,
  Out extends StudentToRelay | TeacherToRelay | ScreenToRelay,
> {
  readonly #connection: Connection<In>;

  /** Connects at once. */
  constructor(
    options: ClassConnectionOptions<Exclude<In, { type: "heartbeat" }>>,
    { role, schema, maxLength = MAX_FRAME_BYTES, since = () => null }: ClassConnectionRole<In>,
  ) {
    const { origin, id, key, onMessage, onStatus, platform = globalPlatform() } = options;
    this.#connection = new Connection<In>({
      urls: connectionUrls(origin, "classes", id),
      platform,
      firstMessages: () => {
        const known = since();
        const hello: ClassHello = { type: "hello", version: PROTOCOL_VERSION, role, key };
        return [encodeFrame({ ...hello, ...(known !== null && { since: known }) })];
      },
      decode: (text) => decodeFrame(schema, text, maxLength),
      received: (message) => {
        if (isContent(message)) onMessage(message);
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
  send(message: Out): void {
    this.#connection.send(encodeFrame(message));
  }

  close(): void {
    this.#connection.close();
  }
}

function isContent<In extends FromRelay>(
  message: In,
): message is Exclude<In, { type: "heartbeat" }> {
  return message.type !== "heartbeat";
}
