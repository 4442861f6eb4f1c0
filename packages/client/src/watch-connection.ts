import {
  decodeFrame,
  encodeFrame,
  PROTOCOL_VERSION,
  relayToDriverSchema,
  type CloseReason,
  type Marks,
  type RelayToDriver,
  type Snapshot,
  isTemporary,
} from "@corridor/protocol";
import { Connection } from "./connection.ts";
import { globalPlatform, type HttpResponse, type Platform } from "./platform.ts";
import { connectionUrls } from "./connection-urls.ts";
import { retryDelay } from "./retry-delay.ts";
import { DelayedAcknowledgements } from "./delayed-acknowledgements.ts";

/** Delay before a failed request for the maze is repeated. */
const RETRY_MS = 2_000;

export type WatchStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** it reconnects automatically */
  | { kind: "lost"; reason: CloseReason }
  /** the key or the robot is gone */
  | { kind: "over"; reason: CloseReason };

export interface WatchConnectionOptions {
  /** of the service, such as https://robots.example.org */
  origin: string;
  id: string;
  /** a watch key */
  key: string;
  onSnapshot(snapshot: Snapshot): void;
  /**
   * The maze as JSON; null if it is unknown. Called after each connection and when it changes.
   */
  onMaze(text: string | null): void;
  /** A script has marked cells of the maze; fresh without cells: its marks end. */
  onMarks?(marks: Marks): void;
  onStatus(status: WatchStatus): void;
  /** default: the platform of browsers, workers and Node */
  platform?: Omit<Platform, "uniqueText">;
}

/**
 * A viewer's connection: receives the snapshots and the maze of a robot. It can run in a worker.
 */
export class WatchConnection {
  readonly #options: WatchConnectionOptions;
  readonly #platform: Omit<Platform, "uniqueText">;
  readonly #connection: Connection<RelayToDriver>;
  readonly #acknowledgements = new DelayedAcknowledgements();
  /** cancels the current or next request for the maze */
  #cancelMaze: () => void = () => undefined;

  /** Connects at once. */
  constructor(options: WatchConnectionOptions) {
    const { origin, id, key, platform = globalPlatform() } = options;
    this.#options = options;
    this.#platform = platform;
    this.#connection = new Connection({
      urls: connectionUrls(origin, "robots", id),
      platform,
      firstMessages: () => [
        encodeFrame({ type: "hello", version: PROTOCOL_VERSION, role: "watch", key }),
      ],
      decode: (text) => decodeFrame(relayToDriverSchema, text),
      received: (message) => this.#received(message),
      changed: (status) => {
        if (status.kind === "connected") this.#requestMaze();
        else this.#cancelMaze();
        options.onStatus(status);
      },
    });
    this.#connection.open();
  }

  /** Reconnects at once instead of waiting for the next attempt. */
  open(): void {
    this.#connection.open();
  }

  close(): void {
    this.#cancelMaze();
    this.#connection.close();
  }

  #received(message: RelayToDriver): void {
    switch (message.type) {
      case "welcome":
        this.#acknowledgements.reset();
        if (message.snapshot !== null) this.#read(message.snapshot);
        return;
      case "snapshot":
        return this.#read(message.snapshot);
      case "maze":
        return this.#requestMaze();
      case "marks": {
        const { type: _type, ...marks } = message;
        return this.#options.onMarks?.(marks);
      }
      case "ack":
      case "state":
      case "gap":
      case "problem":
      case "heartbeat":
        return;
    }
  }

  #read(snapshot: Snapshot): void {
    this.#options.onSnapshot(snapshot);
    // The next long poll acknowledges it.
    if (this.#connection.transport === "long-poll") return;
    if (!this.#acknowledgements.read(this.#platform.clock.now())) return;
    this.#connection.send(encodeFrame({ type: "seen", seq: snapshot.seq }));
  }

  #requestMaze(): void {
    this.#cancelMaze();
    const { origin, id, key } = this.#options;
    const { request, clock } = this.#platform;
    if (request === undefined) return;
    let isCancelled = false;
    const url = `${origin}/api/v1/robots/${id}/maze`;
    const pending = request({ method: "GET", url, key, body: null });
    let cancelTimer = (): void => undefined;
    const retry = (response: HttpResponse | null): void => {
      if (isCancelled) return;
      cancelTimer = clock.after(retryDelay(response, RETRY_MS), () => this.#requestMaze());
    };
    this.#cancelMaze = () => {
      isCancelled = true;
      cancelTimer();
      pending.cancel();
    };
    const responded = (response: HttpResponse): void => {
      if (isCancelled) return;
      const { status, body } = response;
      if (status === 200) this.#options.onMaze(body);
      else if (status === 404) this.#options.onMaze(null);
      // The connection itself reports a revoked key.
      else if (isTemporary(response)) retry(response);
    };
    pending.response.then(responded, () => retry(null));
  }
}
