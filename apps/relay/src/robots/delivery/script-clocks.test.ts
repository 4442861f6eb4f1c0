import { expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { ScriptClocks } from "./script-clocks.ts";

const AT = Date.UTC(2026, 0, 1);

it("two scripts of one key on different computers have separate clocks", () => {
  const clocks = new ScriptClocks();
  clocks.came("key", { clock: "computer-1", sentAt: 9_000_000 }, AT);
  expect(clocks.came("key", { clock: "computer-2", sentAt: 5 }, AT)).toBe(0);
  expect(clocks.came("key", { clock: "computer-2", sentAt: 1_005 }, AT + 1_000)).toBe(0);
});

it("a clock id of one key is separate from the same id of another key", () => {
  const clocks = new ScriptClocks();
  clocks.came("key 1", { clock: "the-same-id", sentAt: 9_000_000 }, AT);
  expect(clocks.came("key 2", { clock: "the-same-id", sentAt: 5 }, AT)).toBe(0);
});

it("a key with ever more clocks loses the oldest one, never one in use", () => {
  const clocks = new ScriptClocks();
  const held = (): number => clocks.came("key", { clock: "in-use-01", sentAt: 1_000 }, AT + 3_000);
  clocks.came("key", { clock: "in-use-01", sentAt: 0 }, AT);
  clocks.came("key", { clock: "idle-0001", sentAt: 0 }, AT);
  for (let n = 0; n < 10 * limits.clocksPerKey; n++) {
    clocks.came("key", { clock: `other-${n}`, sentAt: 0 }, AT);
    expect(held()).toBeGreaterThan(1_900);
  }
  expect(clocks.came("key", { clock: "idle-0001", sentAt: 0 }, AT + 3_000)).toBe(0);
});

it("a request without a time has no transit", () => {
  expect(new ScriptClocks().came("key", null, AT)).toBe(0);
});
