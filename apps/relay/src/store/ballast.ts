/**
 * Room that is held back for bad times. A full disk refuses even to delete; giving the ballast up lets
 * robots end what they run and people delete what they have, until somebody makes room.
 */
import { closeSync, fsyncSync, openSync, rmSync, statSync, writeSync } from "node:fs";

/** Some hundred steps, and the log of SQLite at its longest. */
const BYTES = 4 * 1024 * 1024;

export interface Ballast {
  /** @returns false when it was given up before */
  giveUp(): boolean;
  /** Holds the room back, if there is as much. @returns whether it is held now */
  hold(): boolean;
}

/** Ballast of so many bytes in a file of its own. */
export class BallastFile implements Ballast {
  readonly #path: string;
  #isHeld = false;

  constructor(path: string) {
    this.#path = path;
  }

  giveUp(): boolean {
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
      this.giveUp();
    }
    return this.#isHeld;
  }

  #isWhole(): boolean {
    return statSync(this.#path, { throwIfNoEntry: false })?.size === BYTES;
  }

  #write(): void {
    const file = openSync(this.#path, "w", 0o600);
    try {
      // Written, not only sized: a file with holes holds no room back.
      const written = writeSync(file, Buffer.alloc(BYTES));
      if (written < BYTES) throw new Error("no disk space for the reserve file");
      fsyncSync(file);
    } finally {
      closeSync(file);
    }
  }
}
