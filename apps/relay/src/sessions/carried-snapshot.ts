/**
 * A snapshot on its way through the relay: checked, and still the bytes that its page wrote. Most are passed on
 * as they came, and nobody here ever asks for more than their numbers; who does gets the object.
 */
import { findSnapshotMessage, type Snapshot, type SnapshotPlace } from "@corridor/protocol";

/** What a reader's message says before the snapshot, and behind it. */
const BEFORE = Buffer.from('{"type":"snapshot","snapshot":');
const AFTER = Buffer.from("}");

export class CarriedSnapshot {
  readonly seq: number;
  readonly tick: number;
  readonly state: Snapshot["state"];
  /** the message to a reader, the same bytes for all of them */
  readonly message: Buffer;
  #value: Snapshot | null = null;

  private constructor({ seq, tick, state }: Snapshot | SnapshotPlace, message: Buffer) {
    this.seq = seq;
    this.tick = tick;
    this.state = state;
    this.message = message;
  }

  /** One that was made or read as an object. */
  static of(value: Snapshot): CarriedSnapshot {
    const json = Buffer.from(JSON.stringify(value));
    const carried = new CarriedSnapshot(value, Buffer.concat([BEFORE, json, AFTER]));
    carried.#value = value;
    return carried;
  }

  /** One that was found among bytes. It has its own copy: those may be few of many that came at once. */
  static found(bytes: Buffer, place: SnapshotPlace): CarriedSnapshot {
    const { start, end } = place;
    const message = Buffer.allocUnsafe(BEFORE.length + end - start + AFTER.length);
    BEFORE.copy(message);
    bytes.copy(message, BEFORE.length, start, end);
    AFTER.copy(message, message.length - AFTER.length);
    return new CarriedSnapshot(place, message);
  }

  /** The snapshot by itself, as JSON. */
  get json(): Buffer {
    return this.message.subarray(BEFORE.length, -AFTER.length);
  }

  get value(): Snapshot {
    this.#value ??= JSON.parse(this.json.toString()) as Snapshot;
    return this.#value;
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
