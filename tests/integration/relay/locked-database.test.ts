import { spawn } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import { expect, it, onTestFinished } from "vitest";
import { SqliteFile } from "../../../apps/relay/src/store/sqlite/file/sqlite-file.ts";
import { SqliteRobotStore } from "../../../apps/relay/src/store/sqlite/sqlite-robot-store.ts";
import { testFolder } from "../../../apps/relay/src/testing/test-relay.ts";

it("rejects a file that another relay holds, until that relay exits", async () => {
  const file = join(testFolder(), "corridor.sqlite");
  const other = startOther(file);
  onTestFinished(() => void other.kill("SIGKILL"));
  await once(other.stdout, "data");
  expect(() => new SqliteFile(file, { waitMs: 100 })).toThrow(
    /Another Corridor uses this database/,
  );
  other.kill("SIGKILL");
  await once(other, "exit");
  await new SqliteRobotStore(file).close();
});

/** Starts a process that opens the file and prints that it did. */
function startOther(file: string) {
  const store = JSON.stringify(
    join(import.meta.dirname, "../../../apps/relay/src/store/sqlite/sqlite-robot-store.ts"),
  );
  const script = `const { SqliteRobotStore } = await import(${store});
    globalThis.store = new SqliteRobotStore(${JSON.stringify(file)});
    console.log("open"); setInterval(() => {}, 1000);`;
  return spawn(process.execPath, ["--input-type=module", "--eval", script], {
    stdio: ["ignore", "pipe", "inherit"],
  });
}
