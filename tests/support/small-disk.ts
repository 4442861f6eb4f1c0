/** An in-memory disk of a few MiB that tests can fill up. */
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

  /** @returns null where mounting a tmpfs needs root or is not supported */
  static mount(folder: string, mebibytes: number): SmallDisk | null {
    if (process.platform !== "linux" || process.getuid?.() !== 0) return null;
    mkdirSync(folder, { recursive: true });
    const args = ["-t", "tmpfs", "-o", `size=${mebibytes}m`, "tmpfs", folder];
    const { status } = spawnSync("mount", args, { stdio: "ignore" });
    return status === 0 ? new SmallDisk(folder, mebibytes * 1024 * 1024) : null;
  }

  /** Fills the disk completely. */
  fill(): void {
    for (let size = this.#bytes; size >= 512; size /= 2) {
      try {
        writeFileSync(this.#filler, Buffer.alloc(size), { flag: "a" });
      } catch {
        // Does not fit; try half the size.
      }
    }
  }

  freeSpace(): void {
    rmSync(this.#filler, { force: true });
  }

  unmount(): void {
    spawnSync("umount", [this.folder], { stdio: "ignore" });
  }
}
