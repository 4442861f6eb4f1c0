import { expect, it, vi } from "vitest";
import { FakeClock, settled } from "../testing/fake-clock.ts";
import { CheckQueue } from "./check-queue.ts";

const rule = { perSecond: 5, waiting: 3 };
const wrong = async () => null;
const right = async () => "robot";

function withQueue(all: typeof rule | null = null) {
  const clock = new FakeClock();
  const began = clock.now();
  const queue = new CheckQueue(clock, rule, all);
  const times: [string, number][] = [];
  /** notes when a check ran */
  const noted = (name: string, check: () => Promise<string | null>) => async () => {
    times.push([name, clock.now() - began]);
    return check();
  };
  return { clock, queue, times, noted };
}

it("checks right codes at once, however many come", async () => {
  const { queue } = withQueue();
  for (let count = 0; count < 120; count++) expect(await queue.run("a", right)).toBe("robot");
});

it("checks at most five codes a second of an address that sends wrong ones, in order", async () => {
  const { clock, queue, times, noted } = withQueue();
  const answers = ["1", "2", "3"].map((name) => queue.run("a", noted(name, wrong)));
  const last = queue.run("a", noted("4", right));
  await settled();
  await clock.pass(1_000);
  expect(times).toEqual([
    ["1", 0],
    ["2", 200],
    ["3", 400],
    ["4", 600],
  ]);
  expect(await Promise.all(answers)).toEqual([null, null, null]);
  expect(await last).toBe("robot");
});

it("delays no other address", async () => {
  const { queue } = withQueue();
  await queue.run("a", wrong);
  const waiting = queue.run("a", right);
  expect(await queue.run("b", right)).toBe("robot");
  queue.close();
  await expect(waiting).rejects.toMatchObject({ kind: "restarting" });
});

it("refuses a code unchecked when too many wait, and checks the next as soon as there is room", async () => {
  const { clock, queue } = withQueue();
  const check = vi.fn<typeof wrong>(wrong);
  await queue.run("a", check);
  const waiting = [1, 2, 3].map(() => queue.run("a", check));
  await expect(queue.run("a", check)).rejects.toMatchObject({
    kind: "too-fast",
    headers: { "Retry-After": "1" },
  });
  expect(check).toHaveBeenCalledTimes(1);
  await clock.pass(200);
  const next = queue.run("a", right);
  await clock.pass(1_000);
  expect(await next).toBe("robot");
  await Promise.all(waiting);
});

it("shares a limit among all addresses", async () => {
  const { clock, queue, times, noted } = withQueue({ perSecond: 100, waiting: 3 });
  const answers = ["a", "b", "c"].map((name) => queue.run(name, noted(name, wrong)));
  await settled();
  await clock.pass(100);
  expect(times).toEqual([
    ["a", 0],
    ["b", 10],
    ["c", 20],
  ]);
  await Promise.all(answers);
});

it("does not count a store that fails as a wrong code, and stores no address for longer than the delay", async () => {
  const { clock, queue } = withQueue();
  await expect(queue.run("a", () => Promise.reject(new Error("disk")))).rejects.toThrow("disk");
  await settled();
  expect(queue.size).toBe(0);
  await queue.run("a", wrong);
  await settled();
  expect(queue.size).toBe(1);
  await clock.pass(200);
  expect(queue.size).toBe(0);
});
