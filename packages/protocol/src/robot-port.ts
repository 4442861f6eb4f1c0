/**
 * A robot as other protocols use it. Gateways and bridges know nothing else of Corridor: a robot
 * inside the relay and a client on the network have the same port, and pass the same test cases.
 */
import { z } from "zod";
import { idempotencyKeySchema, type CommandRecord } from "./command-record.ts";
import { describeProblem, readValue } from "./document-reader.ts";
import type { EventGap } from "./events.ts";
import { orderSchema, type Order } from "./order.ts";
import type { ProblemDocument } from "./problem.ts";
import type { Snapshot } from "./snapshot.ts";

/**
 * The port of one script or viewer, for one connection or one request. What the relay or the robot
 * refuses, methods throw as `RefusedError`.
 */
export interface RobotPort {
  /** drive: may send commands; watch: may only read */
  readonly capability: "drive" | "watch";
  /** the newest snapshot; null before the robot's first report, and if the port may not read */
  readonly newest: Snapshot | null;
  /**
   * Follows the robot from now on.
   * @returns a function that ends the subscription
   */
  subscribe(listener: RobotListener): () => void;
  /**
   * Sends a command, which the robot starts in its turn.
   * @param key idempotency key: the same key and command never runs twice. The states of the
   * command contain it, and may arrive before this resolves. Default: one that only the port knows
   * @returns the record, once the command is stored; `duplicate` if it was stored before
   */
  send(order: Order, key?: string): Promise<CommandRecord>;
  /**
   * Waits for the end of a command.
   * @param milliseconds 0 to 25000
   * @returns the record after the wait, ended or not. After a command of this port, `newest` is not
   * older than the end
   */
  endOf(seq: number, milliseconds: number): Promise<CommandRecord>;
  /**
   * Cancels a command of the same key.
   * @returns the record; it has not ended yet if the robot must end it
   */
  cancel(seq: number): Promise<CommandRecord>;
  readMaze(): Promise<PublishedMaze>;
  /** Ends subscriptions and waits. Commands continue. Call no method afterwards. */
  close(): void;
}

/** Callbacks of a subscription. */
export interface RobotListener {
  /** at most 20 a second; the newest before the end of each command */
  snapshot(snapshot: Snapshot): void;
  /** the state of a command of any script changed */
  state(record: CommandRecord): void;
  /** states were missed: all commands have ended except these */
  gap(open: EventGap["open"]): void;
  /** the robot is in another maze */
  maze(version: string): void;
  /**
   * The port may no longer read, or the relay cannot serve it. Called once, as the last one, but
   * not after `close`.
   */
  end(error: RefusedError): void;
}

/** The maze of a robot, as its page published it. */
export interface PublishedMaze {
  /** the document as JSON */
  text: string;
  /** the `ETag`, without its quotes; equal for equal mazes */
  version: string;
}

/** The robot or the relay refuses a request of a port. `message` is the sentence of the problem. */
export class RefusedError extends Error {
  override readonly name = "RefusedError";
  readonly problem: ProblemDocument;
  /** seconds after which the same request may succeed; null: it does not */
  readonly retryAfter: number | null;

  constructor(
    problem: ProblemDocument,
    options: ErrorOptions & { retryAfter?: number | null } = {},
  ) {
    const { retryAfter = null, ...others } = options;
    super(problem.detail, others);
    this.problem = problem;
    this.retryAfter = retryAfter;
  }
}

/** Why a key that only watches does not permit a command. */
export const READ_ONLY =
  "A watch key permits only reading. To send commands, ask the robot's owner for an address with a driver key.";

const keyedSchema = z.object({ key: idempotencyKeySchema.optional() });

/**
 * Checks a command, whose numbers come from another protocol.
 * @throws RefusedError bad-request
 */
export function checkCommand(order: Order, key: string | undefined): void {
  const results = [readValue(orderSchema, order), readValue(keyedSchema, { key })];
  const errors = results.flatMap((result) => (result.ok ? [] : result.problems));
  const [first] = errors;
  if (first === undefined) return;
  throw new RefusedError({
    type: "/problems/bad-request",
    title: "Invalid request",
    status: 400,
    detail: `Invalid command. ${describeProblem(first)}.`.replaceAll('"', "'"),
    errors,
  });
}
