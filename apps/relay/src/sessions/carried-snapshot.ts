/**
 * A snapshot on its way through the relay: checked, and still the bytes that its page wrote. Most are passed on
 * as they came, and nobody here ever asks for more than their numbers; who does gets the object.
 */
import { findSnapshotMessage, type Snapshot, type SnapshotSpan } from "@corridor/protocol";
import { emptyFrame, messageIn } from "../text-frame.ts";

/** What a reader's message says before the snapshot, and behind it. */
const BEFORE = Buffer.from('{"type":"snapshot","snapshot":');
const AFTER = "}".charCodeAt(0);

export class CarriedSnapshot {
  readonly seq: number;
  readonly tick: number;
  readonly state: Snapshot["state"];
  /** the message to a reader as a WebSocket carries it, the same bytes for all of them */
  readonly frame: Buffer;
  #value: Snapshot | null = null;

  private constructor({ seq, tick, state }: Snapshot | SnapshotSpan, frame: Buffer) {
    this.seq = seq;
    this.tick = tick;
    this.state = state;
    this.frame = frame;
  }

  /** One that was made or read as an object. Its memory is its own: it may be kept for hours. */
  static of(value: Snapshot): CarriedSnapshot {
    const json = Buffer.from(JSON.stringify(value));
    const carried = new CarriedSnapshot(value, framed(json, 0, json.length, { isRetained: true }));
    carried.#value = value;
    return carried;
  }

  /** One that was found among bytes, copied into memory that it shares with others of the same moment. */
  static found(bytes: Buffer, place: SnapshotSpan): CarriedSnapshot {
    return new CarriedSnapshot(place, framed(bytes, place.start, place.end, { isRetained: false }));
  }

  /** The message by itself. */
  get message(): Buffer {
    return messageIn(this.frame);
  }

  /** The snapshot by itself, as JSON. */
  get json(): Buffer {
    return this.message.subarray(BEFORE.length, -1);
  }

  get value(): Snapshot {
    this.#value ??= JSON.parse(this.json.toString()) as Snapshot;
    return this.#value;
  }

  /** The same with another number, with which nearly all of them begin. */
  numbered(seq: number): CarriedSnapshot {
    const { tick, state, json } = this;
    const before = `{"seq":${this.seq},`;
    if (json.toString("latin1", 0, before.length) !== before) return this.with({ seq });
    const bytes = Buffer.concat([Buffer.from(`{"seq":${seq},`), json.subarray(before.length)]);
    const place = { seq, tick, state, start: 0, end: bytes.length };
    return CarriedSnapshot.found(bytes, place);
  }

  /** The same with another number or state. */
  with(change: Partial<Pick<Snapshot, "seq" | "state">>): CarriedSnapshot {
    return CarriedSnapshot.of({ ...this.value, ...change });
  }
}

/** A page's snapshot message; null for all else, which need not be wrong. */
export function readSnapshotMessage(
  bytes: Buffer,
): { epoch: number; snapshot: CarriedSnapshot } | null {
  // As latin1 a byte is a character, and what is no ASCII is found to be none.
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
