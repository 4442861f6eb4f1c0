/**
 * The port of a robot on the network, for bridges to other protocols. It drives the robot of a
 * `RobotClient`, so it survives lost connections, and works with a physical robot.
 */
import {
  accessProblems,
  checkCommand,
  commandRecordSchema,
  hasEnded,
  problemSchema,
  READ_ONLY,
  readJson,
  RefusedError,
  waitingReason,
  type CommandRecord,
  type Marks,
  type Order,
  type ProblemDocument,
  type PublishedMaze,
  type RelayToDriver,
  type RobotListener,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";
import { requestApi, type ApiRequest } from "./api-request.ts";
import { ClientError } from "./client-error.ts";
import { clientParts, type ClientParts } from "./client-parts.ts";
import { isWatchKey } from "./close-error.ts";
import type { HttpResponse } from "./platform.ts";
import type { RobotClient } from "./robot-client.ts";

/** Commands whose newest record is in memory: more than a robot may have waiting. */
const MAX_RECORDS = 200;
/** Longest record: 200 conditions. */
const MAX_RECORD = 64 * 1024;

/** A port of a script, which may draw marks over the maze. */
export interface MarkingPort extends RobotPort {
  /** Sends at most 10 messages a second. While there is no connection, nothing is sent. */
  mark(marks: Marks): void;
}

/**
 * Opens the port of a client. Use only the port from then on; its `close` closes the client.
 */
export function openPort(client: RobotClient): MarkingPort {
  const parts = clientParts.get(client);
  if (parts === undefined) throw new TypeError("not a RobotClient");
  return new ClientPort(parts, () => client.close());
}

class ClientPort implements MarkingPort {
  readonly capability: RobotPort["capability"];
  readonly #parts: ClientParts;
  readonly #closeClient: () => void;
  readonly #listeners = new Set<RobotListener>();
  /** newest records of the port's commands by seq, oldest first; empty after missed states */
  readonly #records = new Map<number, CommandRecord>();
  /** called when records have changed, or the client has ended */
  readonly #changed = new Set<() => void>();
  readonly #requests = new Set<ApiRequest>();
  /** version of the maze that was read or announced last; null: none */
  #maze: string | null = null;

  constructor(parts: ClientParts, closeClient: () => void) {
    this.capability = isWatchKey(parts.api.key) ? "watch" : "drive";
    this.#parts = parts;
    this.#closeClient = closeClient;
    parts.observers.add({
      received: (message) => this.#received(message),
      ended: (error) => this.#ended(error),
    });
  }

  get newest(): Snapshot | null {
    return this.#parts.end() === null ? this.#parts.newest() : null;
  }

  subscribe(listener: RobotListener): () => void {
    this.#checkOpen();
    this.#listeners.add(listener);
    return () => void this.#listeners.delete(listener);
  }

  async send(order: Order, key?: string): Promise<CommandRecord> {
    this.#checkDrives();
    checkCommand(order, key);
    try {
      return await this.#parts.send(order, key);
    } catch (error) {
      throw refused(error);
    }
  }

  async endOf(seq: number, milliseconds: number): Promise<CommandRecord> {
    this.#checkOpen();
    const { clock } = this.#parts.api.platform;
    const until = clock.now() + milliseconds;
    for (;;) {
      const record = this.#records.get(seq);
      const leftMs = until - clock.now();
      // Unknown: a command of an earlier connection, or its states may have been missed.
      if (record === undefined) return this.#requestEnd(seq, Math.max(0, leftMs));
      if (hasEnded(record.state)) return record;
      if (leftMs <= 0) return { ...record, reason: this.#waitingReason() };
      await this.#change(leftMs);
      this.#checkOpen();
    }
  }

  async cancel(seq: number): Promise<CommandRecord> {
    this.#checkDrives();
    return recordIn(await this.#request("DELETE", `/commands/${seq}`));
  }

  async readMaze(): Promise<PublishedMaze> {
    this.#checkOpen();
    const { body, etag } = await this.#request("GET", "/maze");
    const version = (etag ?? "").replace(/^W\//, "").replaceAll('"', "");
    this.#maze = version;
    return { text: body, version };
  }

  mark(marks: Marks): void {
    this.#parts.mark(marks);
  }

  close(): void {
    this.#listeners.clear();
    this.#closeClient();
  }

  #received(message: RelayToDriver): void {
    switch (message.type) {
      case "welcome":
      case "snapshot":
        // The relay does not repeat that the maze has changed while the connection was lost.
        if (message.type === "welcome") this.#lookForMaze().catch(() => undefined);
        return this.#notify((listener) => {
          if (message.snapshot !== null) listener.snapshot(message.snapshot);
        });
      case "ack":
        return this.#remember(message.record);
      case "state":
        if (this.#records.has(message.record.seq)) this.#remember(message.record);
        return this.#notify((listener) => listener.state(message.record));
      case "gap":
        this.#records.clear();
        this.#wake();
        return this.#notify((listener) => listener.gap(message.open));
      case "maze":
        this.#maze = message.version;
        return this.#notify((listener) => listener.maze(message.version));
      case "marks":
      case "problem":
      case "heartbeat":
        return;
    }
  }

  async #lookForMaze(): Promise<void> {
    const known = this.#maze;
    if (known === null) return;
    const { version } = await this.readMaze();
    if (version !== known) this.#notify((listener) => listener.maze(version));
  }

  #ended(error: ClientError): void {
    for (const request of this.#requests) request.cancel();
    this.#wake();
    this.#notify((listener) => listener.end(refused(error)));
    this.#listeners.clear();
  }

  #notify(call: (listener: RobotListener) => void): void {
    for (const listener of this.#listeners) call(listener);
  }

  #remember(record: CommandRecord): void {
    this.#records.set(record.seq, { ...record, duplicate: false });
    const [oldest] = this.#records.keys();
    if (this.#records.size > MAX_RECORDS && oldest !== undefined) this.#records.delete(oldest);
    this.#wake();
  }

  #wake(): void {
    for (const wake of this.#changed) wake();
    this.#changed.clear();
  }

  /** Waits until a record changes, states are missed, or the client ends. */
  async #change(milliseconds: number): Promise<void> {
    await new Promise<void>((resolve) => {
      const cancelTimer = this.#parts.api.platform.clock.after(milliseconds, resolve);
      this.#changed.add(() => {
        cancelTimer();
        resolve();
      });
    });
  }

  /** Why a command does not end; null if the robot is neither gone nor paused. */
  #waitingReason(): string | null {
    const obstacle = this.#parts.newest() === null ? "absent" : this.#parts.obstacle();
    return obstacle === null ? null : waitingReason(obstacle);
  }

  async #requestEnd(seq: number, milliseconds: number): Promise<CommandRecord> {
    const wait = (milliseconds / 1000).toFixed(3);
    return recordIn(await this.#request("GET", `/commands/${seq}?wait=${wait}`, milliseconds));
  }

  /** @param waitMs time that the relay may wait before it responds */
  async #request(method: "GET" | "DELETE", path: string, waitMs = 0): Promise<HttpResponse> {
    const { api } = this.#parts;
    const timeoutMs = api.timeoutMs + waitMs;
    const request = requestApi({ ...api, timeoutMs }, method, path);
    this.#requests.add(request);
    const result = await request.response;
    this.#requests.delete(request);
    this.#checkOpen();
    if (result === null) throw unreachable();
    if (result.status >= 400) throw refusedResponse(result);
    return result;
  }

  /** @throws RefusedError if the client has ended */
  #checkOpen(): void {
    const error = this.#parts.end();
    if (error !== null) throw refused(error);
  }

  #checkDrives(): void {
    this.#checkOpen();
    if (this.capability === "watch") throw refusal("forbidden", READ_ONLY);
  }
}

function recordIn({ body }: HttpResponse): CommandRecord {
  const record = readJson(commandRecordSchema, body, MAX_RECORD);
  if (!record.ok) throw unreachable();
  return record.value;
}

/** The kinds of problems that the client itself finds, as the relay describes them. */
const kinds = {
  ...accessProblems,
  unreachable: { status: 504, title: "The robot's host does not respond" },
} as const;

function refusal(kind: keyof typeof kinds, detail: string, cause?: unknown): RefusedError {
  const problem: ProblemDocument = {
    type: `/problems/${kind}`,
    ...kinds[kind],
    detail,
    errors: [],
  };
  return new RefusedError(problem, { cause });
}

function unreachable(cause?: unknown): RefusedError {
  const detail = "The robot's host does not respond. Check the network and the robot's address.";
  return refusal("unreachable", detail, cause);
}

/** An error of the client, as ports throw it. */
function refused(error: unknown): RefusedError {
  if (!(error instanceof ClientError)) throw error;
  const problem = problemSchema.safeParse(error.cause);
  if (problem.success) return new RefusedError(problem.data, { cause: error });
  const { code, hint } = error;
  const isKnown = code === "not-authorised" || code === "blocked" || code === "no-robot";
  return isKnown ? refusal(code, hint, error) : unreachable(error);
}

function refusedResponse({ body }: HttpResponse): RefusedError {
  const problem = readJson(problemSchema, body, MAX_RECORD);
  return problem.ok ? new RefusedError(problem.value) : unreachable();
}
