/**
 * The port of a robot at this relay, for gateways of other protocols. It has the permissions of its
 * key at every moment: what the owner blocks, pauses or revokes ends here as for a native script.
 */
import {
  checkCommand,
  termsOf,
  type CommandRecord,
  type Order,
  type PublishedMaze,
  type RobotListener,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";
import { asRefused, noRobot, Refusal, restarting } from "../platform/errors/problems.ts";
import { StoreUnavailableError } from "../platform/errors/store-unavailable.ts";
import { type Caller, type Verb, scriptIsBlocked } from "./access/callers.ts";
import { keyRevoked } from "./access/key-ring.ts";
import { noMaze } from "./maze-board.ts";
import type { OverReason, ReaderSink } from "./readers/feed.ts";
import type { JoinedReader } from "./readers/readers.ts";
import type { Grant } from "./registry.ts";
import type { Robot } from "./robot.ts";

/** The gateway's connection, which limits how much is sent to a slow client. */
export type PortConnection = Pick<ReaderSink, "transport" | "flow">;

export class RelayPort implements RobotPort {
  readonly capability: RobotPort["capability"];
  readonly #robot: Robot;
  readonly #caller: Caller;
  readonly #connection: PortConnection;
  readonly #readers = new Set<JoinedReader>();
  readonly #waits = new Set<AbortController>();

  constructor({ robot, caller }: Grant, connection: PortConnection) {
    this.capability = caller.kind === "drive" ? "drive" : "watch";
    this.#robot = robot;
    this.#caller = caller;
    this.#connection = connection;
  }

  get newest(): Snapshot | null {
    try {
      this.#check("read");
    } catch {
      return null;
    }
    return this.#robot.newest?.value ?? null;
  }

  subscribe(listener: RobotListener): () => void {
    let reader: JoinedReader | null = null;
    const leave = (): void => {
      if (reader === null) return;
      this.#readers.delete(reader);
      reader.leave();
    };
    const sink: ReaderSink = {
      ...this.#connection,
      began: () => undefined,
      snapshot: ({ value }) => listener.snapshot(value),
      state: ({ record }) => listener.state(record),
      gap: ({ open }) => listener.gap(open),
      maze: (version) => listener.maze(version),
      over: (reason) => {
        leave();
        listener.end(asRefused(endings[reason]()));
      },
    };
    try {
      this.#check("read");
      reader = this.#robot.readers.join(this.#caller, sink, null);
    } catch (error) {
      throw asRefused(error);
    }
    this.#readers.add(reader);
    return leave;
  }

  async send(order: Order, key?: string): Promise<CommandRecord> {
    return this.#run("command", async () => {
      this.#robot.spoke(this.#caller);
      try {
        checkCommand(order, key);
      } catch (error) {
        this.#robot.refused(this.#caller, error);
        throw error;
      }
      const { promise, resolve, reject } = Promise.withResolvers<CommandRecord>();
      const request = { key: key ?? null, ...termsOf(order) };
      this.#robot.submit(this.#caller, request, resolve).catch(reject);
      return promise;
    });
  }

  async endOf(seq: number, milliseconds: number): Promise<CommandRecord> {
    return this.#run("log", async () => {
      const wait = new AbortController();
      const markAnswered = this.#robot.received(this.#caller);
      this.#waits.add(wait);
      try {
        const limit = { milliseconds, signal: wait.signal, key: this.#caller };
        return await this.#robot.endOf(seq, limit);
      } finally {
        this.#waits.delete(wait);
        markAnswered();
      }
    });
  }

  async cancel(seq: number): Promise<CommandRecord> {
    return this.#run("command", async () => {
      this.#robot.spoke(this.#caller);
      return this.#robot.cancel(this.#caller, seq);
    });
  }

  async readMaze(): Promise<PublishedMaze> {
    return this.#run("look", async () => {
      const maze = await this.#robot.mazes.read();
      if (maze === null) throw noMaze();
      return maze;
    });
  }

  close(): void {
    for (const reader of this.#readers) reader.leave();
    this.#readers.clear();
    for (const wait of this.#waits) wait.abort();
  }

  /** Runs a request if the key permits it. The end of the robot explains why it failed meanwhile. */
  async #run<T>(verb: Verb, request: () => Promise<T>): Promise<T> {
    try {
      this.#check(verb);
      return await request();
    } catch (error) {
      const { end } = this.#robot;
      throw asRefused(end === null ? error : endings[end]());
    }
  }

  /** @throws Refusal if the key does not permit this now */
  #check(verb: Verb): void {
    const { end } = this.#robot;
    if (end !== null) throw endings[end]();
    this.#robot.check(this.#caller, verb);
  }
}

/** Why a subscription ended, for the client of another protocol. */
const endings: Record<OverReason, () => Error> = {
  over: noRobot,
  restart: restarting,
  revoked: keyRevoked,
  blocked: scriptIsBlocked,
  busy: () => new StoreUnavailableError("the valid keys are unknown"),
  tooSlow: () =>
    new Refusal("too-slow", "The client did not read messages fast enough. Connect again."),
};
