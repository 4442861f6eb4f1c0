/**
 * A net that breaks: TCP connections to a relay that can be cut, held up, cut into small pieces and
 * left half open. What is said on them passes through byte by byte; chance is by a seed.
 */
import { connect, createServer, type AddressInfo, type Server, type Socket } from "node:net";
import type { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { machineNow } from "../clock.ts";

/** From the client to the relay, or back. */
export type Direction = "up" | "down";

/** ms that a piece takes, by chance */
export interface Delay {
  least: number;
  most: number;
}

const NO_DELAY: Delay = { least: 0, most: 0 };

/** A piece of a sliced stream has at most so many bytes. */
const LARGEST_SLICE = 24;

type Side = "client" | "relay";

export interface FaultProxyOptions {
  /** port of this machine to which connections go; asked for each one */
  target: () => number;
  dice: Dice;
}

/** Both sockets of a connection, and the way between them. */
class Joint {
  readonly #ends: Record<Side, Socket>;
  readonly #lanes: Lane[];
  isSilent = false;

  constructor(client: Socket, relay: Socket, proxy: FaultProxy, dice: Dice) {
    this.#ends = { client, relay };
    this.#lanes = [
      new Lane(client, relay, { proxy, dice, direction: "up" }),
      new Lane(relay, client, { proxy, dice, direction: "down" }),
    ];
    for (const end of [client, relay]) {
      end.setNoDelay(true);
      end.on("error", () => this.cut("quiet"));
    }
  }

  get isOpen(): boolean {
    return Object.values(this.#ends).some((end) => !end.destroyed);
  }

  /** Ends both sides, with a reset or as if the other side had closed. */
  cut(how: "reset" | "quiet"): void {
    for (const lane of this.#lanes) lane.close();
    for (const end of Object.values(this.#ends)) {
      if (how === "reset" && !end.destroyed) end.resetAndDestroy();
      else end.destroy();
    }
  }

  /** One side is gone; the other is not told, and nothing that it says arrives. */
  halfOpen(gone: Side): void {
    this.isSilent = true;
    for (const lane of this.#lanes) lane.close();
    this.#ends[gone].destroy();
    this.#ends[gone === "client" ? "relay" : "client"].resume();
  }
}

/** One direction of a connection; what is on its way keeps its order. */
class Lane {
  readonly #to: Socket;
  /** pieces, and null for the end */
  readonly #onTheWay: { at: number; piece: Buffer | null }[] = [];
  #timer: NodeJS.Timeout | null = null;
  #isClosed = false;

  constructor(
    from: Socket,
    to: Socket,
    { proxy, dice, direction }: { proxy: FaultProxy; dice: Dice; direction: Direction },
  ) {
    this.#to = to;
    const put = (piece: Buffer | null): void => {
      const { least, most } = proxy.delays[direction];
      const soon = Date.now() + (most === 0 ? 0 : dice.between(least, most));
      const last = this.#onTheWay.at(-1)?.at ?? 0;
      this.#onTheWay.push({ at: Math.max(last, soon, proxy.heldUntil), piece });
    };
    from.on("data", (data: Buffer) => {
      if (this.#isClosed) return;
      for (const piece of proxy.isSlicing ? slices(data, dice) : [data]) put(piece);
      this.#pump();
      // A reader that does not read holds up who writes to it, as a net does.
      if (!to.writableNeedDrain) return;
      from.pause();
      to.once("drain", () => from.resume());
    });
    from.on("end", () => {
      put(null);
      this.#pump();
    });
  }

  close(): void {
    this.#isClosed = true;
    this.#onTheWay.length = 0;
  }

  #pump(): void {
    if (this.#timer !== null) return;
    for (;;) {
      const [first] = this.#onTheWay;
      if (first === undefined || this.#isClosed || this.#to.destroyed) return;
      const wait = first.at - Date.now();
      if (wait > 0) {
        this.#timer = setTimeout(() => {
          this.#timer = null;
          this.#pump();
        }, wait);
        return;
      }
      this.#onTheWay.shift();
      if (first.piece === null) this.#to.end();
      else this.#to.write(first.piece);
    }
  }
}

function slices(data: Buffer, dice: Dice): Buffer[] {
  const pieces: Buffer[] = [];
  for (let at = 0; at < data.length;) {
    const size = dice.between(1, LARGEST_SLICE);
    pieces.push(data.subarray(at, at + size));
    at += size;
  }
  return pieces;
}

export class FaultProxy {
  readonly #options: FaultProxyOptions;
  readonly #server: Server;
  readonly #joints = new Set<Joint>();
  /** new connections are refused while it is not */
  isUp = true;
  /** ms that each piece takes in each direction, in order */
  readonly delays: Record<Direction, Delay> = { up: NO_DELAY, down: NO_DELAY };
  /** Whether what passes is cut into small pieces. */
  isSlicing = false;
  /** nothing passes before; nothing is lost */
  heldUntil = 0;
  /** connections that were cut or left half open */
  cuts = 0;
  /** when a connection that was opened last was first answered by the relay, by `machineNow` */
  answeredAt = 0;

  private constructor(options: FaultProxyOptions) {
    this.#options = options;
    this.#server = createServer({ pauseOnConnect: true, allowHalfOpen: true }, (client) =>
      this.#accept(client),
    );
  }

  static async start(options: FaultProxyOptions): Promise<FaultProxy> {
    const proxy = new FaultProxy(options);
    await new Promise<void>((resolve) => proxy.#server.listen(0, "127.0.0.1", resolve));
    return proxy;
  }

  /** such as http://127.0.0.1:41234 */
  get origin(): string {
    return `http://127.0.0.1:${(this.#server.address() as AddressInfo).port}`;
  }

  get connections(): number {
    return this.#joints.size;
  }

  /** ms that each piece takes, either way */
  set delay(delay: Delay) {
    this.delays.up = delay;
    this.delays.down = delay;
  }

  /** Ends every connection. @returns how many there were */
  cut(): number {
    const joints = [...this.#joints];
    for (const joint of joints) joint.cut(this.#options.dice.isLucky(0.5) ? "reset" : "quiet");
    this.cuts += joints.length;
    return joints.length;
  }

  /** Cuts them all, and lets no new one in for so long. */
  breakFor(ms: number): number {
    this.isUp = false;
    setTimeout(() => (this.isUp = true), ms);
    return this.cut();
  }

  /** One side of every connection is gone; the other learns of it after so long. */
  halfOpen(gone: Side, ms: number): number {
    const joints = [...this.#joints].filter(({ isSilent }) => !isSilent);
    for (const joint of joints) {
      joint.halfOpen(gone);
      setTimeout(() => joint.cut("reset"), ms);
    }
    this.cuts += joints.length;
    return joints.length;
  }

  /** Nothing passes for so long; then it all comes. */
  hold(ms: number): void {
    this.heldUntil = Date.now() + ms;
  }

  /** Does no harm any more to what comes from now on. */
  mend(): void {
    this.isUp = true;
    this.isSlicing = false;
    this.delay = NO_DELAY;
  }

  async close(): Promise<void> {
    this.isUp = false;
    for (const joint of this.#joints) joint.cut("quiet");
    await new Promise((resolve) => this.#server.close(resolve));
  }

  #accept(client: Socket): void {
    client.on("error", () => client.destroy());
    if (!this.isUp) return void client.resetAndDestroy();
    const relay = connect({
      port: this.#options.target(),
      host: "127.0.0.1",
      allowHalfOpen: true,
    });
    const refuse = (): void => {
      client.destroy();
      relay.destroy();
    };
    relay.once("error", refuse);
    client.once("close", refuse);
    relay.once("connect", () => {
      relay.off("error", refuse);
      client.off("close", refuse);
      const joint = new Joint(client, relay, this, this.#options.dice);
      this.#joints.add(joint);
      relay.once("data", () => (this.answeredAt = machineNow()));
      for (const end of [client, relay]) {
        end.on("close", () => {
          if (!joint.isOpen) this.#joints.delete(joint);
        });
      }
      client.resume();
    });
  }
}
