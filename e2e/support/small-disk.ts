/** A disk of a few MiB, in memory, that can be filled. */
import { spawnSync } from "node:child_process";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

export class SmallDisk {
  readonly folder: string;
  readonly #filler: string;
  readonly #bytes: number;

  private constructor(folder: string, bytes: number) {
    this.folder = folder;
    this.#filler = join(folder, "filler");
    this.#bytes = bytes;
  }

  /** @returns null where this machine lets nobody but root have one, or has no such thing */
  static mount(folder: string, mebibytes: number): SmallDisk | null {
    if (process.platform !== "linux" || process.getuid?.() !== 0) return null;
    mkdirSync(folder, { recursive: true });
    const words = ["-t", "tmpfs", "-o", `size=${mebibytes}m`, "tmpfs", folder];
    const { status } = spawnSync("mount", words, { stdio: "ignore" });
    return status === 0 ? new SmallDisk(folder, mebibytes * 1024 * 1024) : null;
  }

  /** Leaves no room at all. */
  fill(): void {
    for (let size = this.#bytes; size >= 512; size /= 2) {
      try {
        writeFileSync(this.#filler, Buffer.alloc(size), { flag: "a" });
      } catch {
        // Not so much; perhaps half of it.
      }
    }
  }

  makeRoom(): void {
    rmSync(this.#filler, { force: true });
  }

  unmount(): void {
    spawnSync("umount", [this.folder], { stdio: "ignore" });
  }
}
