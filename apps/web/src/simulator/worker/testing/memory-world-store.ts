/** Stored worlds without IndexedDB: the storage of a device, for consecutive pages in tests. */
import type { StoredWorld, WorldEntry, WorldStore } from "../world-store.ts";

interface World {
  writer: string;
  first: object;
  inputs: object[];
  ticks: number;
  digest: string;
  startedAt: number;
  journal: WorldEntry["journal"];
}

export class MemoryWorldStore implements WorldStore {
  readonly worlds = new Map<string, World>();
  /** number of writes */
  writes = 0;
  isFull = false;

  async claim(key: string, writer: string): Promise<StoredWorld | null> {
    await Promise.resolve();
    const world = this.worlds.get(key);
    if (world === undefined) return null;
    world.writer = writer;
    const { first, inputs, ticks, digest, startedAt, journal } = structuredClone(world);
    return { run: { ...first, inputs, ticks, digest }, startedAt, journal };
  }

  async write(key: string, writer: string, entry: WorldEntry) {
    const { update, startedAt, journal } = structuredClone(entry);
    await Promise.resolve();
    if (this.isFull) throw new DOMException("full", "QuotaExceededError");
    const before = this.worlds.get(key);
    if (before !== undefined && before.writer !== writer) return "claimed";
    if (before === undefined && update.first === null) return "gone";
    this.writes += 1;
    const inputs = update.first === null ? [...(before?.inputs ?? [])] : [];
    const first = update.first ?? before?.first ?? {};
    const { ticks, digest } = update;
    this.worlds.set(key, {
      writer,
      first,
      inputs: [...inputs, ...update.inputs],
      ticks,
      digest,
      startedAt,
      journal,
    });
    return "stored";
  }
}
