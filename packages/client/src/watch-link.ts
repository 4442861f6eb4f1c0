/**
 * The line of whoever looks on at a robot: its snapshots, and the maze that it is in. It can run in a
 * worker.
 */
import {
  decodeFrame,
  encodeFrame,
  PROTOCOL_VERSION,
  relayToDriverSchema,
  type CloseReason,
  type RelayToDriver,
  type Snapshot,
} from "@corridor/protocol";
import { Connection } from "./connection.ts";
import { globalPlatform, type Platform } from "./platform.ts";
import { doorUrls } from "./robot-address.ts";
import { SeenPace } from "./delayed-acknowledgements.ts";

/** Pause before the maze is asked for again that the relay could not tell. */
const AGAIN_MS = 2_000;

export type WatchStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** it is tried again by itself */
  | { kind: "lost"; reason: CloseReason }
  /** the key or the robot is gone */
  | { kind: "over"; reason: CloseReason };

export interface WatchLinkOptions {
  /** of the service, such as https://robots.example.org */
  origin: string;
  id: string;
  /** a watch key */
  key: string;
  onSnapshot(snapshot: Snapshot): void;
  /** The maze as JSON; null: nobody knows it. Told with each connection, and when it changes. */
  onMaze(text: string | null): void;
  onStatus(status: WatchStatus): void;
  /** default: what browsers, workers and Node offer */
  platform?: Omit<Platform, "uniqueText">;
}

export class WatchLink {
  readonly #options: WatchLinkOptions;
  readonly #platform: Omit<Platform, "uniqueText">;
  readonly #connection: Connection<RelayToDriver>;
  readonly #seen = new SeenPace();
  /** calls off what is asked of the maze now, or is to be asked later */
  #forgetAsking: () => void = () => undefined;

  /** Opens the line at once. */
  constructor(options: WatchLinkOptions) {
    const { origin, id, key, platform = globalPlatform() } = options;
    this.#options = options;
    this.#platform = platform;
    this.#connection = new Connection({
      urls: doorUrls(origin, id),
      platform,
      greeting: () => [
        encodeFrame({ type: "hello", version: PROTOCOL_VERSION, role: "watch", key }),
      ],
      decode: (text) => decodeFrame(relayToDriverSchema, text),
      received: (message) => this.#received(message),
      changed: (status) => {
        if (status.kind === "connected") this.#askForMaze();
        else this.#forgetAsking();
        options.onStatus(status);
      },
    });
    this.#connection.open();
  }

  /** Tries at once where it waits to try again. */
  open(): void {
    this.#connection.open();
  }

  close(): void {
    this.#forgetAsking();
    this.#connection.close();
  }

  #received(message: RelayToDriver): void {
    switch (message.type) {
      case "welcome":
        this.#seen.begin();
        if (message.snapshot !== null) this.#read(message.snapshot);
        return;
      case "snapshot":
        return this.#read(message.snapshot);
      case "maze":
        return this.#askForMaze();
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
    // By HTTPS the next request says it already.
    if (this.#connection.door === "https") return;
    if (!this.#seen.read(this.#platform.clock.now())) return;
    this.#connection.send(encodeFrame({ type: "seen", seq: snapshot.seq }));
  }

  #askForMaze(): void {
    this.#forgetAsking();
    const { origin, id, key } = this.#options;
    const { ask, clock } = this.#platform;
    if (ask === undefined) return;
    let isWanted = true;
    const url = `${origin}/api/v1/robots/${id}/maze`;
    const asked = ask({ method: "GET", url, key, body: null });
    let cancelTimer = (): void => undefined;
    const later = (): void => {
      if (isWanted) cancelTimer = clock.after(AGAIN_MS, () => this.#askForMaze());
    };
    this.#forgetAsking = () => {
      isWanted = false;
      cancelTimer();
      asked.cancel();
    };
    asked.answer.then(({ status, body }) => {
      if (!isWanted) return;
      if (status === 200) this.#options.onMaze(body);
      else if (status === 404) this.#options.onMaze(null);
      // Who may not look on any more is told by the line itself.
      else if (status === 429 || status >= 500) later();
    }, later);
  }
}
