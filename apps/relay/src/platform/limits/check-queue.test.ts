import { expect, it, vi } from "vitest";
import { FakeClock, settled } from "../testing/fake-clock.ts";
import { CheckQueue } from "./check-queue.ts";

const rule = { perSecond: 5, waiting: 3 };
const wrong = async () => null;
const right = async () => "robot";

function withQueue(all: typeof rule | null = null) {
  const clock = new FakeClock();
  const start = clock.now();
  const queue = new CheckQueue(clock, rule, all);
  const times: [string, number][] = [];
  /** wraps a check to record when it ran */
  const recorded = (name: string, check: () => Promise<string | null>) => async () => {
    times.push([name, clock.now() - start]);
    return check();
  };
  return { clock, queue, times, recorded };
}

it("runs checks of right codes immediately, in any number", async () => {
  const { queue } = withQueue();
  for (let count = 0; count < 120; count++)
    expect(await queue.run("a", "RIGHT", right)).toBe("robot");
});

it("checks at most five codes a second from an address that sends wrong codes, in order", async () => {
  const { clock, queue, times, recorded } = withQueue();
  const answers = ["1", "2", "3"].map((name) => queue.run("a", name, recorded(name, wrong)));
  const last = queue.run("a", "4", recorded("4", right));
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

it("does not delay other addresses", async () => {
  const { queue } = withQueue();
  await queue.run("a", "WRONG", wrong);
  const waiting = queue.run("a", "RIGHT", right);
  expect(await queue.run("b", "RIGHT", right)).toBe("robot");
  queue.close();
  await expect(waiting).rejects.toMatchObject({ kind: "restarting" });
});

it("rejects a code unchecked if too many wait, and accepts the next once there is room", async () => {
  const { clock, queue } = withQueue();
  const check = vi.fn<typeof wrong>(wrong);
  await queue.run("a", "WRONG", check);
  const waiting = [1, 2, 3].map(() => queue.run("a", "WRONG", check));
  await expect(queue.run("a", "WRONG", check)).rejects.toMatchObject({
    kind: "too-fast",
    headers: { "Retry-After": "1" },
  });
  expect(check).toHaveBeenCalledTimes(1);
  await clock.pass(200);
  const next = queue.run("a", "RIGHT", right);
  await clock.pass(1_000);
  expect(await next).toBe("robot");
  await Promise.all(waiting);
});

it("checks a code that was rejected first when it is sent again, while new wrong codes arrive", async () => {
  const { clock, queue, times, recorded } = withQueue();
  const flood: Promise<unknown>[] = [];
  const send = (name: string) => flood.push(queue.run("a", name, recorded(name, wrong)));
  for (const name of ["1", "2", "3", "4"]) send(name);
  await settled();
  await expect(queue.run("a", "mine", right)).rejects.toMatchObject({ kind: "too-fast" });
  await clock.pass(200);
  send("5");
  const mine = queue.run("a", "mine", recorded("mine", right));
  await clock.pass(1_000);
  expect(await mine).toBe("robot");
  expect(times.map(([name]) => name)).toEqual(["1", "2", "mine", "3", "4", "5"]);
  await Promise.all(flood);
});

it("shares one limit between all addresses", async () => {
  const { clock, queue, times, recorded } = withQueue({ perSecond: 100, waiting: 3 });
  const answers = ["a", "b", "c"].map((name) => queue.run(name, name, recorded(name, wrong)));
  await settled();
  await clock.pass(100);
  expect(times).toEqual([
    ["a", 0],
    ["b", 10],
    ["c", 20],
  ]);
  await Promise.all(answers);
});

it("does not count a store failure as a wrong code, and stores an address only during its delay", async () => {
  const { clock, queue } = withQueue();
  await expect(queue.run("a", "WRONG", () => Promise.reject(new Error("disk")))).rejects.toThrow(
    "disk",
  );
  await settled();
  expect(queue.size).toBe(0);
  await queue.run("a", "WRONG", wrong);
  await settled();
  expect(queue.size).toBe(1);
  await clock.pass(200);
  expect(queue.size).toBe(0);
});
