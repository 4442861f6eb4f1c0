/**
 * Newest tiles of a class, and who is connected: the students of this relay and of the others. In
 * memory only. Changes reach the dashboards in batches, those of a watched student immediately.
 */
import type { StudentTile, Tile } from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import { limits } from "../platform/limits/limits.ts";

export interface TileBoardParts {
  clock: Clock;
  isConnected(student: number): boolean;
  isWatched(student: number): boolean;
  /** @param own tiles of this relay's students, for the other relays */
  publish(tiles: StudentTile[], own: StudentTile[]): void;
}

export class TileBoard {
  readonly #parts: TileBoardParts;
  readonly #tiles = new Map<number, Tile>();
  readonly #changed = new Set<number>();
  /** students whose change happened at this relay */
  readonly #own = new Set<number>();
  #cancelTimer: (() => void) | null = null;

  constructor(parts: TileBoardParts) {
    this.#parts = parts;
  }

  /** A student of this relay has sent a tile. */
  sent(student: number, tile: Tile): void {
    this.#tiles.set(student, tile);
    this.#own.add(student);
    this.#mark(student);
  }

  /** Another relay has published tiles. */
  received(tiles: readonly StudentTile[]): void {
    for (const { student, tile } of tiles) {
      if (tile === null) continue;
      this.#tiles.set(student, tile);
      this.#mark(student);
    }
  }

  /** The student has connected or disconnected, here or at another relay. */
  connectionChanged(student: number): void {
    this.#mark(student);
  }

  remove(student: number): void {
    this.#tiles.delete(student);
    this.#changed.delete(student);
    this.#own.delete(student);
  }

  /** All students of whom something is known. */
  all(students: Iterable<number>): StudentTile[] {
    return [...students].map((student) => this.#viewOf(student));
  }

  close(): void {
    this.#cancelTimer?.();
  }

  #mark(student: number): void {
    this.#changed.add(student);
    if (this.#parts.isWatched(student)) return this.#publish([student]);
    this.#cancelTimer ??= this.#parts.clock.after(limits.tilesIntervalMs, () => {
      this.#cancelTimer = null;
      this.#publish([...this.#changed]);
    });
  }

  #publish(students: readonly number[]): void {
    const own = students.filter((student) => this.#own.has(student));
    for (const student of students) {
      this.#changed.delete(student);
      this.#own.delete(student);
    }
    this.#parts.publish(this.all(students), this.all(own));
  }

  #viewOf(student: number): StudentTile {
    const connected = this.#parts.isConnected(student);
    return { student, connected, tile: this.#tiles.get(student) ?? null };
  }
}
