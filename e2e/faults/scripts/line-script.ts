/**
 * A script on a bare WebSocket: no library, so that what it hears and when is the relay's doing
 * alone.
 */
import {
  decodeFrame,
  hasEnded,
  relayToDriverSchema,
  type CommandRecord,
  type Order,
  type Snapshot,
} from "@corridor/protocol";
import { machineNow, until } from "../clock.ts";

const PATIENCE_MS = 30_000;

export class LineScript {
  readonly #socket: WebSocket;
  readonly #postedAt = new Map<string, number>();
  readonly #seqs = new Map<string, number>();
  readonly #started = new Map<number, number>();
  readonly #records = new Map<number, CommandRecord>();
  #newest: Snapshot | null = null;
  #count = 0;
  /** whether the relay has closed it */
  isClosed = false;

  private constructor(socket: WebSocket) {
    this.#socket = socket;
    socket.onmessage = ({ data }: MessageEvent<string>) => this.#heard(data);
    socket.onclose = () => (this.isClosed = true);
  }

  /** Connects as a script and waits for the welcome. */
  static async connect(origin: string, id: string, key: string): Promise<LineScript> {
    const url = `${origin.replace("http", "ws")}/api/v1/robots/${id}/socket`;
    const script = new LineScript(new WebSocket(url));
    await new Promise((resolve, reject) => {
      script.#socket.onopen = resolve;
      script.#socket.onerror = reject;
    });
    script.#say({ type: "hello", version: 1, role: "drive", key });
    return script;
  }

  /** of the newest snapshot */
  get robotState(): Snapshot["state"] | null {
    return this.#newest?.state ?? null;
  }

  /** ms from posting a command until its start was heard; Infinity while it was not */
  startedMs(seq: number): number {
    return this.#started.get(seq) ?? Infinity;
  }

  /** Sends a command. @returns its number, once it is stored */
  async post(order: Order): Promise<number> {
    const key = `line-script-${(this.#count += 1)}`;
    this.#postedAt.set(key, machineNow());
    this.#say({ type: "command", key, command: order });
    await until(() => this.#seqs.has(key), PATIENCE_MS);
    return this.#seqs.get(key) ?? 0;
  }

  /** Sends a command and waits for its end. */
  async run(order: Order): Promise<CommandRecord> {
    const seq = await this.post(order);
    await until(() => hasEnded(this.#records.get(seq)?.state ?? "accepted"), PATIENCE_MS);
    const record = this.#records.get(seq);
    if (record === undefined) throw new Error("The relay does not answer.");
    return record;
  }

  close(): void {
    this.#socket.close();
  }

  #heard(text: string): void {
    const message = decodeFrame(relayToDriverSchema, text);
    if (!message.ok) throw new Error(`The relay said what cannot be read: ${text}`);
    const { value } = message;
    if (value.type === "snapshot") {
      this.#newest = value.snapshot;
      this.#say({ type: "seen", seq: value.snapshot.seq });
    }
    if (value.type === "ack" || value.type === "state") this.#tells(value.record);
  }

  #tells(record: CommandRecord): void {
    const { seq, key, state } = record;
    if (key !== null) this.#seqs.set(key, seq);
    this.#records.set(seq, record);
    const postedAt = this.#postedAt.get(key ?? "");
    if (state !== "started" || postedAt === undefined || this.#started.has(seq)) return;
    this.#started.set(seq, machineNow() - postedAt);
  }

  #say(message: unknown): void {
    this.#socket.send(JSON.stringify(message));
  }
}
