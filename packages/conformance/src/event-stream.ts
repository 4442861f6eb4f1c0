/** The server-sent events of a robot. An open stream does not count as activity of its script. */
import {
  commandRecordSchema,
  eventGapSchema,
  hasEnded,
  snapshotSchema,
  type CommandRecord,
  type EventGap,
  type Snapshot,
} from "@corridor/protocol";
import type { Host } from "./host.ts";
import { must, Mismatch, validate } from "./mismatch.ts";

interface ReceivedState {
  record: CommandRecord;
  /** ms by the clock of the conformance kit */
  at: number;
}

export class EventStream {
  readonly states: ReceivedState[] = [];
  readonly snapshots: { snapshot: Snapshot; at: number }[] = [];
  readonly gaps: EventGap[] = [];
  /** `STREAM-n` of the last state */
  lastId = "";
  readonly #controller = new AbortController();
  readonly #listeners = new Set<() => void>();
  #error: unknown = null;

  private constructor() {}

  /** @param since the last id of an earlier stream */
  static async open(host: Host, since?: string): Promise<EventStream> {
    const stream = new EventStream();
    const headers = since === undefined ? {} : { "Last-Event-ID": since };
    const response = await host.open("/events", stream.#controller.signal, headers);
    must(response.status === 200, "200 for GET /events", response.status);
    const type = response.headers.get("content-type") ?? "none";
    must(type.startsWith("text/event-stream"), "Content-Type: text/event-stream", type);
    void stream.#read(response).catch((error: unknown) => {
      stream.#error = error;
      for (const listener of stream.#listeners) listener();
    });
    return stream;
  }

  close(): void {
    this.#controller.abort();
  }

  /** Waits for a condition. @throws Mismatch after the timeout, or if the stream ends */
  async until<T>(find: () => T | undefined, ms: number, what: string): Promise<T> {
    const deadline = performance.now() + ms;
    for (;;) {
      const found = find();
      if (found !== undefined) return found;
      if (this.#error instanceof Mismatch) throw this.#error;
      must(this.#error === null, what, `the end of the event stream: ${String(this.#error)}`);
      const rest = deadline - performance.now();
      must(rest > 0, what, `nothing of it within ${ms / 1000} s: ${this.#show()}`);
      await this.#nextEvent(rest);
    }
  }

  /** Waits until a command starts. */
  async started(seq: number, ms = 10_000): Promise<ReceivedState> {
    return this.until(
      () => this.states.find(({ record }) => record.seq === seq && record.state === "started"),
      ms,
      `command ${seq} to start`,
    );
  }

  /** Waits for the first final state of a command. */
  async ended(seq: number, ms: number): Promise<ReceivedState> {
    return this.until(
      () => this.states.find(({ record }) => record.seq === seq && hasEnded(record.state)),
      ms,
      `command ${seq} to end`,
    );
  }

  #show(): string {
    return this.states.map(({ record }) => `${record.seq} ${record.state}`).join(", ");
  }

  async #nextEvent(ms: number): Promise<void> {
    await new Promise<void>((resolve) => {
      const done = (): void => {
        clearTimeout(timer);
        this.#listeners.delete(done);
        resolve();
      };
      const timer = setTimeout(done, ms);
      this.#listeners.add(done);
    });
  }

  async #read(response: Response): Promise<void> {
    let text = "";
    for await (const chunk of response.body?.pipeThrough(new TextDecoderStream()) ?? []) {
      text += chunk;
      const blocks = text.split("\n\n");
      text = blocks.pop() ?? "";
      for (const block of blocks) this.#take(block);
      for (const listener of this.#listeners) listener();
    }
    throw new Mismatch("an open event stream", "its end");
  }

  #take(block: string): void {
    const id = /^id: ?(.*)$/m.exec(block)?.[1];
    if (id !== undefined) this.lastId = id;
    const event = /^event: ?(.*)$/m.exec(block)?.[1];
    const data = /^data: ?(.*)$/m.exec(block)?.[1];
    if (event === undefined || data === undefined) return;
    const value: unknown = JSON.parse(data);
    const at = performance.now();
    if (event === "snapshot") {
      this.snapshots.push({ snapshot: validate(snapshotSchema, value, "a snapshot"), at });
    } else if (event === "state") {
      this.states.push({ record: validate(commandRecordSchema, value, "a command record"), at });
    } else if (event === "gap") {
      this.gaps.push(validate(eventGapSchema, value, "a gap"));
    }
  }
}

/** Opens an event stream, runs the callback and closes the stream. */
export async function withEvents<T>(
  host: Host,
  run: (events: EventStream) => Promise<T>,
): Promise<T> {
  const events = await EventStream.open(host);
  try {
    return await run(events);
  } finally {
    events.close();
  }
}
