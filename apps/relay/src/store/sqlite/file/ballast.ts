/**
 * Reserved disk space. A full disk rejects even deletions. After the ballast is released, robots
 * can end running commands and people can delete data until space is free again.
 */
import { closeSync, fsyncSync, openSync, rmSync, statSync, writeSync } from "node:fs";

/** Enough for some hundred steps and the longest SQLite log. */
const BYTES = 4 * 1024 * 1024;

export interface Ballast {
  /** @returns false if it was released before */
  release(): boolean;
  /** Reserves the space if the disk has enough. @returns whether the space is reserved now */
  hold(): boolean;
}

/** Ballast in a file of its own. */
export class BallastFile implements Ballast {
  readonly #path: string;
  #isHeld = false;

  constructor(path: string) {
    this.#path = path;
  }

  release(): boolean {
    const wasHeld = this.#isHeld;
    this.#isHeld = false;
    rmSync(this.#path, { force: true });
    return wasHeld;
  }

  hold(): boolean {
    if (this.#isHeld) return true;
    try {
      if (!this.#isWhole()) this.#write();
      this.#isHeld = true;
    } catch {
      this.release();
    }
    return this.#isHeld;
  }

  #isWhole(): boolean {
    return statSync(this.#path, { throwIfNoEntry: false })?.size === BYTES;
  }

  #write(): void {
    const file = openSync(this.#path, "w", 0o600);
    try {
      // The bytes are written, because a sparse file reserves no space.
      const written = writeSync(file, Buffer.alloc(BYTES));
      if (written < BYTES) throw new Error("no disk space for the reserve file");
      fsyncSync(file);
    } finally {
      closeSync(file);
    }
  }
}
