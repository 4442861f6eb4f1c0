import { describe, expect, it } from "vitest";
import { PartLoader } from "./part-loader.ts";

describe("a part of the page that loads on demand", () => {
  it("is loaded once, however often it is wanted", async () => {
    let fetched = 0;
    const loader = new PartLoader(() => Promise.resolve(++fetched));
    await Promise.all([loader.load(), loader.load()]);
    await loader.load();
    expect(loader.state()).toEqual({ kind: "ready", part: 1 });
  });

  it("can be requested again after a failure", async () => {
    let isOnline = false;
    const loader = new PartLoader(() =>
      isOnline ? Promise.resolve("part") : Promise.reject(new TypeError("Failed to fetch")),
    );
    const seen: string[] = [];
    const end = loader.listen(() => seen.push(loader.state().kind));
    await loader.load();
    isOnline = true;
    await loader.load();
    end();
    expect(seen).toEqual(["loading", "failed", "ready"]);
  });
});
