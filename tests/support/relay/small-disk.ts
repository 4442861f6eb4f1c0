/** A real disk of a few MiB. */
import { spawnSync } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { testFolder } from "../../../apps/relay/src/testing/test-relay.ts";

/**
 * A separate disk in memory, removed after the test. Returns null without the permission to mount.
 */
export function realSmallDisk(mebibytes: number) {
  const folder = testFolder();
  if (!mount(folder, mebibytes)) return null;
  onTestFinished(() => void spawnSync("umount", [folder]));
  const filler = join(folder, "filler");
  return {
    folder,
    fill: () => {
      for (let size = mebibytes * 1024 * 1024; size >= 512; size /= 2) {
        try {
          writeFileSync(filler, Buffer.alloc(size), { flag: "a" });
        } catch {
          // Not enough space. Tries half of it.
        }
      }
    },
    makeRoom: () => rmSync(filler),
  };
}

function mount(folder: string, mebibytes: number): boolean {
  if (process.platform !== "linux" || process.getuid?.() !== 0) return false;
  const options = ["-t", "tmpfs", "-o", `size=${mebibytes}m`, "tmpfs", folder];
  return spawnSync("mount", options, { stdio: "ignore" }).status === 0;
}
