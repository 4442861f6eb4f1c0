/**
 * A script on a bare WebSocket without a client library, so that the times and contents of its
 * messages depend on the relay alone.
 */
import {
  decodeFrame,
  hasEnded,
  relayToDriverSchema,
  type CommandRecord,
  type CommandState,
  type Order,
  type Snapshot,
} from "@corridor/protocol";
import { machineNow, waitUntil } from "../clock.ts";

const TIMEOUT_MS = 30_000;

export class BareSocketScript {
  readonly #socket: WebSocket;
  readonly #postedAt = new Map<string, number>();
  readonly #seqs = new Map<string, number>();
  readonly #started = new Map<number, number>();
  readonly #records = new Map<number, CommandRecord>();
  #newest: Snapshot | null = null;
  #lastTickAt = 0;
  #count = 0;
  /** whether the relay has closed the connection */
  isClosed = false;

  private constructor(socket: WebSocket) {
    this.#socket = socket;
    socket.onmessage = ({ data }: MessageEvent<string>) => this.#receive(data);
    socket.onclose = () => (this.isClosed = true);
  }

  /** Connects as a script and waits for the welcome. */
  static async connect(origin: string, id: string, key: string): Promise<BareSocketScript> {
    const url = `${origin.replace("http", "ws")}/api/v1/robots/${id}/socket`;
    const script = new BareSocketScript(new WebSocket(url));
    await new Promise((resolve, reject) => {
      script.#socket.onopen = resolve;
      script.#socket.onerror = reject;
    });
    script.#send({ type: "hello", version: 1, role: "drive", key });
    return script;
  }

  /** state in the newest snapshot */
  get robotState(): Snapshot["state"] | null {
    return this.#newest?.state ?? null;
  }

  /** when the newest tick of the robot arrived */
  get lastTickAt(): number {
    return this.#lastTickAt;
  }

  /** ms from posting a command until its start was reported; Infinity before that */
  startedMs(seq: number): number {
    return this.#started.get(seq) ?? Infinity;
  }

  /** Sends a command. @returns its number, once the relay has stored it */
  async post(order: Order): Promise<number> {
    const key = `line-script-${(this.#count += 1)}`;
    this.#postedAt.set(key, machineNow());
    this.#send({ type: "command", key, command: order });
    await waitUntil(() => this.#seqs.has(key), TIMEOUT_MS);
    return this.#seqs.get(key) ?? 0;
  }

  /** Sends a command and waits until it ends. */
  async run(order: Order): Promise<CommandRecord> {
    const seq = await this.post(order);
    await waitUntil(() => hasEnded(this.#records.get(seq)?.state ?? "accepted"), TIMEOUT_MS);
    const record = this.#records.get(seq);
    if (record === undefined) throw new Error("The relay does not answer.");
    return record;
  }

  /**
   * Turns the robot to and fro, one command after the other.
   * @returns a function that ends this, and resolves with the final state of each command
   */
  keepTurning(): () => Promise<CommandState[]> {
    let isOver = false;
    const turning = (async () => {
      const ends: CommandState[] = [];
      while (!isOver) {
        const action = ends.length % 2 === 0 ? "left 90" : "right 90";
        ends.push((await this.run({ action })).state);
      }
      return ends;
    })();
    return async () => {
      isOver = true;
      return turning;
    };
  }

  close(): void {
    this.#socket.close();
  }

  #receive(text: string): void {
    const message = decodeFrame(relayToDriverSchema, text);
    if (!message.ok) throw new Error(`The relay sent an invalid message: ${text}`);
    const { value } = message;
    if (value.type === "snapshot") {
      if (value.snapshot.tick !== this.#newest?.tick) this.#lastTickAt = machineNow();
      this.#newest = value.snapshot;
      this.#send({ type: "seen", seq: value.snapshot.seq });
    }
    if (value.type === "ack" || value.type === "state") this.#recordState(value.record);
  }

  #recordState(record: CommandRecord): void {
    const { seq, key, state } = record;
    if (key !== null) this.#seqs.set(key, seq);
    this.#records.set(seq, record);
    const postedAt = this.#postedAt.get(key ?? "");
    if (state !== "started" || postedAt === undefined || this.#started.has(seq)) return;
    this.#started.set(seq, machineNow() - postedAt);
  }

  #send(message: unknown): void {
    this.#socket.send(JSON.stringify(message));
  }
}
