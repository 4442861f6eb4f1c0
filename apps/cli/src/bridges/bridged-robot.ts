/**
 * The robot of a bridge. The bridge has one connection to it, which survives lost networks, and
 * opens a port for each program that connects to the bridge.
 */
import { randomUUID } from "node:crypto";
import type { MarkingPort } from "@corridor/client/bridge";
import {
  isVelocity,
  type CommandRecord,
  type Marks,
  type Order,
  type PublishedMaze,
  type RefusedError,
  type RobotListener,
  type RobotPort,
  type Snapshot,
} from "@corridor/protocol";
import { clock } from "./clock.ts";
import { OwnCommands } from "./own-commands.ts";

/** Time to end the commands of the bridge when it stops. */
const STOP_MS = 2_000;

/** The port of the bridge's connection. Marks need not be supported. */
type BridgePort = RobotPort & Partial<Pick<MarkingPort, "mark">>;

export class BridgedRobot {
  readonly #port: BridgePort;
  readonly #commands = new OwnCommands();
  /** resolves with the reason if the bridge may no longer use the robot; not after `close` */
  readonly ended: Promise<RefusedError>;

  /** @param port of the bridge's connection */
  constructor(port: BridgePort) {
    this.#port = port;
    this.ended = new Promise((resolve) => {
      port.subscribe({
        snapshot: () => undefined,
        state: (record) => this.#commands.state(record),
        gap: (open) => this.#commands.gap(open),
        maze: () => undefined,
        end: resolve,
      });
    });
  }

  get capability(): RobotPort["capability"] {
    return this.#port.capability;
  }

  /** @returns a port for one program; its `close` ends motions of this program without an end */
  openPort(options: ProgramPortOptions = {}): RobotPort {
    return new ProgramPort(this.#port, this.#commands, options);
  }

  /** Draws marks over the maze in the page. */
  mark(marks: Marks): void {
    this.#port.mark?.(marks);
  }

  /** Ends all commands of the bridge, in at most 2 s. Other scripts continue. */
  async stop(): Promise<void> {
    let cancelTimer = (): void => undefined;
    const timeout = new Promise<void>((resolve) => (cancelTimer = clock.after(STOP_MS, resolve)));
    await Promise.race([cancelAll(this.#port, this.#commands.all()), timeout]);
    cancelTimer();
  }

  close(): void {
    this.#port.close();
  }
}

interface ProgramPortOptions {
  /** whether `close` leaves a velocity to its lease, as at the relay; default: it ends the velocity */
  keepsVelocities?: boolean;
}

class ProgramPort implements RobotPort {
  readonly #port: RobotPort;
  readonly #commands: OwnCommands;
  readonly #keepsVelocities: boolean;
  readonly #leave = new Set<() => void>();

  constructor(
    port: RobotPort,
    commands: OwnCommands,
    { keepsVelocities = false }: ProgramPortOptions,
  ) {
    this.#port = port;
    this.#commands = commands;
    this.#keepsVelocities = keepsVelocities;
  }

  get capability(): RobotPort["capability"] {
    return this.#port.capability;
  }

  get newest(): Snapshot | null {
    return this.#port.newest;
  }

  subscribe(listener: RobotListener): () => void {
    const leave = this.#port.subscribe(listener);
    this.#leave.add(leave);
    return () => {
      this.#leave.delete(leave);
      leave();
    };
  }

  send(order: Order, key: string = randomUUID()): Promise<CommandRecord> {
    const sent = this.#port.send(order, key);
    this.#commands.add({ owner: this, order, key }, sent);
    return sent;
  }

  endOf(seq: number, milliseconds: number): Promise<CommandRecord> {
    return this.#port.endOf(seq, milliseconds);
  }

  cancel(seq: number): Promise<CommandRecord> {
    return this.#port.cancel(seq);
  }

  readMaze(): Promise<PublishedMaze> {
    return this.#port.readMaze();
  }

  /** The connection of the bridge remains, so it would keep motions without an end alive. */
  close(): void {
    for (const leave of this.#leave) leave();
    this.#leave.clear();
    const isMeant = (order: Order): boolean =>
      isEndless(order) && !(this.#keepsVelocities && isVelocity(order));
    void cancelAll(this.#port, this.#commands.seqsOf(this, isMeant));
  }
}

function isEndless(order: Order): boolean {
  if (order.action === "drive") return order.milliseconds === undefined;
  return order.action === "forward" || order.action === "reverse";
}

/** Never rejects: a command that cannot be cancelled has ended, or the robot is out of reach. */
async function cancelAll(port: RobotPort, commands: Promise<readonly number[]>): Promise<void> {
  const seqs = await commands;
  await Promise.allSettled(seqs.map((seq) => port.cancel(seq)));
}
