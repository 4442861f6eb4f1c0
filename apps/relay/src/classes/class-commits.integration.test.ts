import { join } from "node:path";
import { expect, it, onTestFinished, vi } from "vitest";
import { limits } from "../platform/limits/limits.ts";
import { FakeClock, settled } from "../platform/testing/fake-clock.ts";
import { SqliteFile } from "../store/sqlite/file/sqlite-file.ts";
import { SqliteClassStore } from "../store/sqlite/sqlite-class-store.ts";
import { classRow } from "../store/testing/class-row.ts";
import { testFolder } from "../testing/test-relay.ts";
import { ClassCommits } from "./class-commits.ts";
import { stateOf } from "./class-state.ts";
import { unchanged } from "./step.ts";
import { lockStep } from "./teacher-steps.ts";

const row = classRow();

/** One relay of a class. `locked` is what its dashboards were last sent. */
function relayOf(id: string, store: SqliteClassStore, clock: FakeClock) {
  const shown = { locked: row.isLocked };
  const commits: ClassCommits = new ClassCommits(id, stateOf({ row, students: [] }), {
    store,
    clock,
    listener: {
      committed: () => undefined,
      changed: () => void (shown.locked = commits.state.row.isLocked),
      ended: () => undefined,
    },
  });
  return { commits, shown };
}

it("shows a missed change once the store responds again, without a request", async () => {
  const file = new SqliteFile(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => file.close());
  const store = new SqliteClassStore(file);
  const [id, clock] = ["AAAAAAAAAAAAAAAAAAAAAA", new FakeClock()];
  await store.create({ id, row, lesson: "{}", code: "hash" });
  const [a, b] = [relayOf(id, store, clock), relayOf(id, store, clock)];
  await a.commits.run(lockStep(true));

  const load = vi.spyOn(store, "load").mockRejectedValue(new Error("the store does not respond"));
  b.commits.missed();
  const refused = b.commits.run((state) => unchanged(state));
  await expect(refused).rejects.toThrow("the store does not respond");
  await clock.pass(4 * limits.storeRetryMs);
  // One attempt for the request, and one for each delay.
  expect(load).toHaveBeenCalledTimes(5);
  expect(b.shown.locked).toBe(false);

  load.mockRestore();
  await clock.pass(limits.storeRetryMs);
  await settled();
  expect(b.shown.locked).toBe(true);
});
