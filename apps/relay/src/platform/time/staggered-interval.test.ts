import { expect, it } from "vitest";
import { StaggeredInterval } from "./staggered-interval.ts";
import { FakeClock, settled } from "../testing/fake-clock.ts";

function withMembers(count: number) {
  const clock = new FakeClock();
  const startedAt = clock.now();
  const members = new Set(Array.from({ length: count }, (_, n) => n));
  const visits: { member: number; at: number }[] = [];
  const hold = { until: Promise.resolve() };
  const sweep = new StaggeredInterval({
    clock,
    everyMs: 1_000,
    members: () => members,
    visit: async (member) => {
      visits.push({ member, at: clock.now() - startedAt });
      await hold.until;
    },
  });
  const perTurn = (): number[] =>
    [...Map.groupBy(visits, ({ at }) => at).values()].map((v) => v.length);
  return { clock, members, visits, hold, sweep, perTurn };
}

it("visits the few members of a small relay together, once in each period", async () => {
  const { clock, visits } = withMembers(2);
  await clock.pass(3_000);
  expect(visits.map(({ member, at }) => [member, at])).toEqual([
    [0, 1_000],
    [1, 1_000],
    [0, 2_000],
    [1, 2_000],
    [0, 3_000],
    [1, 3_000],
  ]);
});

it.each([
  [500, 10],
  [10_000, 200],
])(
  "visits each of %i members once in a period, and at most %i in a turn",
  async (count, maxPerTurn) => {
    const { clock, visits, perTurn } = withMembers(count);
    await clock.pass(1_990);
    expect(visits.map(({ member }) => member)).toEqual(Array.from({ length: count }, (_, n) => n));
    expect(Math.max(...perTurn())).toBe(maxPerTurn);
    await clock.pass(1_000);
    expect(visits).toHaveLength(2 * count);
    const again = visits[count];
    expect(again).toEqual({ member: 0, at: 2_000 });
  },
);

it("delays the next pass until the visits of the current one have ended", async () => {
  const { clock, visits, hold } = withMembers(1);
  const { promise, resolve } = Promise.withResolvers<void>();
  hold.until = promise;
  await clock.pass(5_000);
  expect(visits).toHaveLength(1);
  resolve();
  await settled();
  await clock.pass(249);
  expect(visits).toHaveLength(1);
  await clock.pass(1);
  expect(visits).toHaveLength(2);
});

it("completes a pass in time if every turn is late", async () => {
  const { clock, visits } = withMembers(500);
  const after = clock.after.bind(clock);
  clock.after = (ms, call) => after(ms + 85, call);
  await clock.pass(1_000 + 800);
  expect(visits).toHaveLength(500);
});

it("starts no other pass if it is closed during a visit", async () => {
  const { clock, visits, hold, sweep } = withMembers(1);
  const { promise, resolve } = Promise.withResolvers<void>();
  hold.until = promise;
  await clock.pass(1_500);
  sweep.close();
  resolve();
  await clock.pass(10_000);
  expect(visits).toHaveLength(1);
});

it("visits no member after it is closed, even within a pass", async () => {
  const { clock, visits, sweep } = withMembers(100);
  await clock.pass(1_015);
  expect(visits).toHaveLength(20);
  sweep.close();
  await clock.pass(10_000);
  expect(visits).toHaveLength(20);
});
