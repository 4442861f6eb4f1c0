/**
 * A proxy that injects network faults: TCP connections to a relay can be cut, stalled, sliced into
 * small pieces and left half open. Bytes pass unchanged. A seeded random source decides.
 */
import { connect, createServer, type AddressInfo, type Server, type Socket } from "node:net";
import type { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { machineNow } from "../clock.ts";

/** from the client to the relay, or back */
export type Direction = "up" | "down";

/** delay of a piece in ms, at random between the bounds */
export interface Delay {
  min: number;
  max: number;
}

const NO_DELAY: Delay = { min: 0, max: 0 };

/** maximum size of a piece of a sliced stream, in bytes */
const MAX_SLICE = 24;

type Side = "client" | "relay";

export interface FaultProxyOptions {
  /** port of this machine to connect to, requested for each connection */
  target: () => number;
  random: SeededRandom;
}

/** Both sockets of a connection, and the pipes between them. */
class ProxiedConnection {
  readonly #ends: Record<Side, Socket>;
  readonly #pipes: Pipe[];
  isSilent = false;

  constructor(client: Socket, relay: Socket, proxy: FaultProxy, random: SeededRandom) {
    this.#ends = { client, relay };
    this.#pipes = [
      new Pipe(client, relay, { proxy, random, direction: "up" }),
      new Pipe(relay, client, { proxy, random, direction: "down" }),
    ];
    for (const socket of [client, relay]) {
      socket.setNoDelay(true);
      socket.on("error", () => this.cut("quiet"));
    }
  }

  get isOpen(): boolean {
    return Object.values(this.#ends).some((socket) => !socket.destroyed);
  }

  /** Closes both sides, with a reset or as if the peer had closed. */
  cut(how: "reset" | "quiet"): void {
    for (const pipe of this.#pipes) pipe.close();
    for (const socket of Object.values(this.#ends)) {
      if (how === "reset" && !socket.destroyed) socket.resetAndDestroy();
      else socket.destroy();
    }
  }

  /** Disconnects one side. The other side gets no notice, and its data is discarded. */
  halfOpen(side: Side): void {
    this.isSilent = true;
    for (const pipe of this.#pipes) pipe.close();
    this.#ends[side].destroy();
    this.#ends[side === "client" ? "relay" : "client"].resume();
  }
}

/** One direction of a connection. Delayed pieces keep their order. */
class Pipe {
  readonly #to: Socket;
  /** delayed pieces, with null for the end of the stream */
  readonly #inTransit: { at: number; piece: Buffer | null }[] = [];
  #timer: NodeJS.Timeout | null = null;
  #isClosed = false;

  constructor(
    from: Socket,
    to: Socket,
    { proxy, random, direction }: { proxy: FaultProxy; random: SeededRandom; direction: Direction },
  ) {
    this.#to = to;
    const enqueue = (piece: Buffer | null): void => {
      const { min, max } = proxy.delays[direction];
      const earliest = Date.now() + (max === 0 ? 0 : random.between(min, max));
      const last = this.#inTransit.at(-1)?.at ?? 0;
      this.#inTransit.push({ at: Math.max(last, earliest, proxy.stalledUntil), piece });
    };
    from.on("data", (data: Buffer) => {
      if (this.#isClosed) return;
      for (const piece of proxy.isSlicing ? slices(data, random) : [data]) enqueue(piece);
      this.#deliver();
      // Backpressure: a receiver that does not read stops the sender, as on a real network.
      if (!to.writableNeedDrain) return;
      from.pause();
      to.once("drain", () => from.resume());
    });
    from.on("end", () => {
      enqueue(null);
      this.#deliver();
    });
  }

  close(): void {
    this.#isClosed = true;
    this.#inTransit.length = 0;
  }

  #deliver(): void {
    if (this.#timer !== null) return;
    for (;;) {
      const [first] = this.#inTransit;
      if (first === undefined || this.#isClosed || this.#to.destroyed) return;
      const wait = first.at - Date.now();
      if (wait > 0) {
        this.#timer = setTimeout(() => {
          this.#timer = null;
          this.#deliver();
        }, wait);
        return;
      }
      this.#inTransit.shift();
      if (first.piece === null) this.#to.end();
      else this.#to.write(first.piece);
    }
  }
}

function slices(data: Buffer, random: SeededRandom): Buffer[] {
  const pieces: Buffer[] = [];
  for (let at = 0; at < data.length;) {
    const size = random.between(1, MAX_SLICE);
    pieces.push(data.subarray(at, at + size));
    at += size;
  }
  return pieces;
}

export class FaultProxy {
  readonly #options: FaultProxyOptions;
  readonly #server: Server;
  readonly #connections = new Set<ProxiedConnection>();
  /** whether new connections are accepted */
  isUp = true;
  /** delay of each piece in ms, in each direction */
  readonly delays: Record<Direction, Delay> = { up: NO_DELAY, down: NO_DELAY };
  /** whether data is cut into small pieces */
  isSlicing = false;
  /** time before which nothing passes; nothing is lost */
  stalledUntil = 0;
  /** number of connections that were cut or left half open */
  cuts = 0;
  /** `machineNow` when the newest connection received its first response from the relay */
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

  /** origin such as http://127.0.0.1:41234 */
  get origin(): string {
    return `http://127.0.0.1:${(this.#server.address() as AddressInfo).port}`;
  }

  get connections(): number {
    return this.#connections.size;
  }

  /** Sets the delay of both directions. */
  set delay(delay: Delay) {
    this.delays.up = delay;
    this.delays.down = delay;
  }

  /** Cuts every connection. @returns the number of cut connections */
  cut(): number {
    const connections = [...this.#connections];
    for (const connection of connections)
      connection.cut(this.#options.random.chance(0.5) ? "reset" : "quiet");
    this.cuts += connections.length;
    return connections.length;
  }

  /** Cuts every connection, and refuses new ones for `ms`. */
  breakFor(ms: number): number {
    this.isUp = false;
    setTimeout(() => (this.isUp = true), ms);
    return this.cut();
  }

  /** Leaves every connection half open: one side disconnects, and the other is reset after `ms`. */
  halfOpen(side: Side, ms: number): number {
    const connections = [...this.#connections].filter(({ isSilent }) => !isSilent);
    for (const connection of connections) {
      connection.halfOpen(side);
      setTimeout(() => connection.cut("reset"), ms);
    }
    this.cuts += connections.length;
    return connections.length;
  }

  /** Stalls all data for `ms`, then delivers it. */
  stall(ms: number): void {
    this.stalledUntil = Date.now() + ms;
  }

  /** Removes all faults for data from now on. */
  clearFaults(): void {
    this.isUp = true;
    this.isSlicing = false;
    this.delay = NO_DELAY;
  }

  async close(): Promise<void> {
    this.isUp = false;
    for (const connection of this.#connections) connection.cut("quiet");
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
      const connection = new ProxiedConnection(client, relay, this, this.#options.random);
      this.#connections.add(connection);
      relay.once("data", () => (this.answeredAt = machineNow()));
      for (const socket of [client, relay]) {
        socket.on("close", () => {
          if (!connection.isOpen) this.#connections.delete(connection);
        });
      }
      client.resume();
    });
  }
}
