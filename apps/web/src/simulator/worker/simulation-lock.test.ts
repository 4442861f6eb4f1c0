import { afterEach, expect, it, vi } from "vitest";
import { SimulationLock } from "./simulation-lock.ts";

afterEach(() => vi.unstubAllGlobals());

it("holds one lock from Run to Pause, so that browsers do not freeze the hidden page", async () => {
  const held: Promise<void>[] = [];
  const request = (_name: string, _options: object, callback: () => Promise<void>) =>
    held.push(callback());
  vi.stubGlobal("navigator", { locks: { request } });
  const lock = new SimulationLock();
  lock.hold(false);
  lock.hold(true);
  lock.hold(true);
  expect(held).toHaveLength(1);
  lock.hold(false);
  await held[0];
  lock.hold(true);
  expect(held).toHaveLength(2);
});

it("does without a lock on an insecure origin", () => {
  vi.stubGlobal("navigator", {});
  const lock = new SimulationLock();
  lock.hold(true);
  expect(() => lock.hold(false)).not.toThrow();
});
