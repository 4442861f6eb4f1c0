import { describe, expect, it } from "vitest";
import { Bench, momentOf, tenSeconds } from "./testing/bench.ts";
import { loadRun } from "./testing/load-run.ts";

describe("a file", () => {
  it("opened later continues as the run itself would have", () => {
    const bench = tenSeconds();
    const saved = bench.loop.saveRun();
    if (!saved.ok) throw new Error(saved.reason);
    const other = new Bench();
    const tick = bench.loop.snapshot().tick + 77;
    expect(loadRun(other.loop, saved.run, tick)).toMatchObject({ ok: true });
    expect(other.frame()).toMatchObject({ view: "now", trailReset: true, snapshot: { tick } });
    for (const { loop } of [bench, other]) loop.run();
    bench.pass(1000 + (77 * 1000) / 60, 1000 / 60);
    other.pass(1000, 1000 / 60);
    for (const { loop } of [bench, other]) loop.pause();
    const ticks = [bench, other].map(({ loop }) => loop.snapshot().tick);
    const least = Math.min(...ticks);
    const moments = [bench, other].map((each) => {
      each.loop.seek(least);
      return momentOf(each.frame().snapshot);
    });
    expect(moments[0]).toEqual(moments[1]);
  });

  it("whose digest differs from the replay is rejected, and nothing has changed", () => {
    const bench = tenSeconds();
    const saved = bench.loop.saveRun();
    if (!saved.ok) throw new Error(saved.reason);
    const { tick } = bench.loop.snapshot();
    const loaded = loadRun(bench.loop, { ...saved.run, digest: "0123456789abcdef" });
    expect(loaded).toMatchObject({
      ok: false,
      problems: [{ path: "digest", found: "0123456789abcdef" }],
    });
    expect(bench.loop.snapshot().tick).toBe(tick);
  });
});
