/**
 * A validated snapshot that the relay forwards as bytes. Where possible, the relay copies the
 * page's bytes unchanged and reads only `seq`, `tick` and `state`. Only access to `value` parses
 * the object.
 */
import { findSnapshotMessage, type Snapshot, type SnapshotSpan } from "@corridor/protocol";
import { emptyFrame, messageIn } from "../platform/text-frame.ts";

/** Bytes of a reader's message before and after the snapshot. */
const BEFORE = Buffer.from('{"type":"snapshot","snapshot":');
const AFTER = "}".charCodeAt(0);

export class CarriedSnapshot {
  readonly seq: number;
  readonly tick: number;
  readonly state: Snapshot["state"];
  /** the complete WebSocket frame, which all readers share */
  readonly frame: Buffer;
  #value: Snapshot | null = null;

  private constructor({ seq, tick, state }: Snapshot | SnapshotSpan, frame: Buffer) {
    this.seq = seq;
    this.tick = tick;
    this.state = state;
    this.frame = frame;
  }

  /** Creates a snapshot from an object. Its buffer is not pooled, so it may be stored for hours. */
  static of(value: Snapshot): CarriedSnapshot {
    const json = Buffer.from(JSON.stringify(value));
    const carried = new CarriedSnapshot(value, framed(json, 0, json.length, { isRetained: true }));
    carried.#value = value;
    return carried;
  }

  /** Creates a snapshot from a span of bytes. The copy may share a pooled buffer. */
  static found(bytes: Buffer, place: SnapshotSpan): CarriedSnapshot {
    return new CarriedSnapshot(place, framed(bytes, place.start, place.end, { isRetained: false }));
  }

  /** The message without its frame header. */
  get message(): Buffer {
    return messageIn(this.frame);
  }

  /** The snapshot as JSON, without the message around it. */
  get json(): Buffer {
    return this.message.subarray(BEFORE.length, -1);
  }

  get value(): Snapshot {
    this.#value ??= JSON.parse(this.json.toString()) as Snapshot;
    return this.#value;
  }

  /**
   * Copies the snapshot with another seq. If the JSON starts with `seq`, only bytes are replaced.
   */
  numbered(seq: number): CarriedSnapshot {
    const { tick, state, json } = this;
    const before = `{"seq":${this.seq},`;
    if (json.toString("latin1", 0, before.length) !== before) return this.with({ seq });
    const bytes = Buffer.concat([Buffer.from(`{"seq":${seq},`), json.subarray(before.length)]);
    const place = { seq, tick, state, start: 0, end: bytes.length };
    return CarriedSnapshot.found(bytes, place);
  }

  /** Copies the snapshot with another seq or state. */
  with(change: Partial<Pick<Snapshot, "seq" | "state">>): CarriedSnapshot {
    return CarriedSnapshot.of({ ...this.value, ...change });
  }
}

/** Fast path for a page's snapshot message. Returns null for all other input, valid or invalid. */
export function readSnapshotMessage(
  bytes: Buffer,
): { epoch: number; snapshot: CarriedSnapshot } | null {
  // In latin1 each byte is one character. `findSnapshotMessage` rejects non-ASCII characters.
  const place = findSnapshotMessage(bytes.toString("latin1"));
  return place && { epoch: place.epoch, snapshot: CarriedSnapshot.found(bytes, place) };
}

function framed(
  bytes: Buffer,
  start: number,
  end: number,
  keeping: { isRetained: boolean },
): Buffer {
  const length = BEFORE.length + end - start + 1;
  const frame = emptyFrame(length, keeping);
  const at = frame.length - length;
  BEFORE.copy(frame, at);
  bytes.copy(frame, at + BEFORE.length, start, end);
  frame[frame.length - 1] = AFTER;
  return frame;
}
