import { expect, it } from "vitest";
import { replayAddress, replayStart, withoutReplayStart } from "./replay-start.ts";

it("stands in the address of a run that plays from a tick", () => {
  const { search, hash } = new URL(replayAddress("1AbC", 744), "https://corridor.example");
  expect(replayStart(search)).toBe(744);
  expect(hash).toBe("#1AbC");
});

it.each(["", "?from=", "?from=-1", "?from=1e9", "?from=1.5", "?lang=de"])(
  "is missing in %j",
  (search) => {
    expect(replayStart(search)).toBeNull();
  },
);

it("is removed once the run is open, and the language stays", () => {
  expect(withoutReplayStart("?lang=de&from=7")).toBe("?lang=de");
  expect(withoutReplayStart("?from=7")).toBe("");
});
