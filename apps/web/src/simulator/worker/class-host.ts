/** The student's connection to a class. Loads when the page of a student connects. */
import {
  StudentConnection,
  type ClassMessage,
  type ConnectionStatus,
  type StudentConnectionOptions,
} from "@corridor/client/learn";
import { endingOf } from "../protocol/class-ending.ts";
import type {
  ClassHint,
  ClassRequest,
  ClassSession,
  ClassStatus,
  ClassStudent,
} from "../protocol/class-messages.ts";
import { TileFeed, type TileRun } from "./tile-feed.ts";

/** Least time between two requests for help: the relay accepts one in a second. */
const HELP_INTERVAL_MS = 1_000;
const NO_OTHER_NAME = "/problems/no-other-name";

export interface ClassHostPorts {
  /** origin of the page and its relay */
  origin: string;
  /** milliseconds since 1970 */
  now(): number;
  /** the live run */
  run(): TileRun;
  onSession(session: ClassSession): void;
  /** The teacher shows a hint. */
  onHint(hint: ClassHint): void;
  /** Calls once after `ms`. @returns a function that cancels the call */
  after(ms: number, call: () => void): () => void;
  /** default: the worker's own */
  platform?: NonNullable<StudentConnectionOptions["platform"]>;
}

export class ClassHost {
  readonly #ports: ClassHostPorts;
  /** null: not opened, closed, or ended by the relay */
  #connection: StudentConnection | null = null;
  #key: string | null = null;
  #status: ClassStatus = { kind: "connecting" };
  #student: ClassStudent | null = null;
  /** as the relay last received it */
  #sentHelp = false;
  /** cancels the next request for help; null: the next one is sent at once */
  #cancelHelp: (() => void) | null = null;
  readonly #tiles: TileFeed;

  constructor(ports: ClassHostPorts) {
    this.#ports = ports;
    this.#tiles = new TileFeed({ run: () => ports.run(), now: () => ports.now() });
  }

  /** Sends a tile if it is due. @param hasChanged whether the run has changed since the last call */
  update(hasChanged: boolean): void {
    if (hasChanged) this.#tiles.changed();
    const connection = this.#connection;
    if (connection?.isConnected !== true) return;
    const tile = this.#tiles.take(this.#student?.watched === true);
    if (tile !== null) connection.send({ type: "tile", tile });
  }

  handle(request: ClassRequest): void {
    switch (request.kind) {
      case "open":
        return this.#open(request.id, request.key);
      case "close":
        return this.#close();
      case "help":
        // The welcome of the next connection would replace it.
        if (this.#connection?.isConnected !== true) return;
        this.#change({ helpWanted: request.wanted });
        return this.#sendHelp();
      case "name":
        if (this.#connection?.isConnected !== true) return;
        this.#connection.send({ type: "name" });
        return this.#change({ rename: "requested" });
      case "send":
        return this.#connection?.send(request.report);
      case "place":
        return this.#tiles.place(request.place);
    }
  }

  #open(id: string, key: string): void {
    if (this.#connection !== null && key === this.#key) return this.#connection.open();
    this.#close();
    if (key !== this.#key) this.#student = null;
    this.#key = key;
    const { origin, platform } = this.#ports;
    // The first status arrives before the constructor returns.
    this.#connection = new StudentConnection({
      origin,
      id,
      key,
      onMessage: (message) => this.#received(message),
      onStatus: (status) => this.#linkChanged(status),
      ...(platform === undefined ? {} : { platform }),
    });
  }

  #close(): void {
    this.#cancelHelp?.();
    this.#cancelHelp = null;
    this.#connection?.close();
    this.#connection = null;
  }

  #received(message: ClassMessage): void {
    switch (message.type) {
      case "welcome": {
        const { name, renamesLeft, helpWanted, watched, lesson, paceTo, progress } = message;
        const program = this.#student?.stored.program ?? 0;
        // The relay may have lost the newest one.
        this.#tiles.restart();
        const pauseEndsAt = this.#pauseEnd(message.pauseEndsInMs);
        this.#sentHelp = helpWanted;
        // `connected` follows and posts it.
        this.#student = {
          name,
          renamesLeft,
          helpWanted,
          watched,
          pauseEndsAt,
          rename: "possible",
          lesson,
          paceTo,
          stored: { progress, program },
        };
        return;
      }
      case "name": {
        const { name, renamesLeft } = message;
        return this.#change({ name, renamesLeft, rename: "possible" });
      }
      case "watched":
        return this.#change({ watched: message.watched });
      case "problem": {
        if (this.#student?.rename !== "requested") return;
        const isRefused = message.problem.type === NO_OTHER_NAME;
        return this.#change({ rename: isRefused ? "refused" : "possible" });
      }
      case "pause":
        return this.#change({ pauseEndsAt: this.#pauseEnd(message.endsInMs) });
      case "lesson":
        return this.#change({ lesson: message.version });
      case "pace":
        return this.#change({ paceTo: message.to });
      case "hint":
        // The teacher has seen the request, and helps.
        this.#change({ helpWanted: false });
        this.#sendHelp();
        return this.#ports.onHint({ task: message.task, hint: message.hint });
      case "stored": {
        const { what, seq } = message;
        const stored = this.#student?.stored;
        return stored && this.#change({ stored: { ...stored, [what]: seq } });
      }
    }
  }

  /** Sends the newest request, and never faster than the relay accepts: it confirms none. */
  #sendHelp(): void {
    const wanted = this.#student?.helpWanted ?? false;
    if (this.#cancelHelp !== null || wanted === this.#sentHelp) return;
    if (this.#connection?.isConnected !== true) return;
    this.#connection.send({ type: "help", wanted });
    this.#sentHelp = wanted;
    this.#cancelHelp = this.#ports.after(HELP_INTERVAL_MS, () => {
      this.#cancelHelp = null;
      this.#sendHelp();
    });
  }

  #linkChanged(status: ConnectionStatus): void {
    if (status.kind !== "over") return this.#setStatus({ kind: status.kind });
    this.#connection = null;
    return this.#setStatus({ kind: "over", reason: endingOf(status.reason.code) });
  }

  #pauseEnd(endsInMs: number | null): number | null {
    return endsInMs === null ? null : this.#ports.now() + endsInMs;
  }

  #change(change: Partial<ClassStudent>): void {
    if (this.#student === null) return;
    this.#student = { ...this.#student, ...change };
    this.#setStatus(this.#status);
  }

  #setStatus(status: ClassStatus): void {
    this.#status = status;
    this.#ports.onSession({ status, student: this.#student });
  }
}
