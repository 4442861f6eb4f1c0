import { join } from "node:path";
import { onTestFinished } from "vitest";
import { testFolder } from "../../apps/relay/src/testing/test-relay.ts";
import { SmallDisk } from "./small-disk.ts";

/**
 * Mounts an in-memory disk that is removed after the test. Skips the test without the permission to
 * mount.
 */
export function smallDisk(mebibytes: number, skip: (why: string) => never): SmallDisk {
  const disk =
    SmallDisk.mount(join(testFolder(), "disk"), mebibytes) ??
    skip("mounting a small disk needs Linux and root");
  onTestFinished(() => disk.unmount());
  return disk;
}
