import { expect, it } from "vitest";
import { Sweep } from "./sweep.ts";
import { FakeClock, settled } from "./testing/fake-clock.ts";

function withMembers(count: number) {
  const clock = new FakeClock();
  const begun = clock.now();
  const members = new Set(Array.from({ length: count }, (_, n) => n));
  const visits: { member: number; at: number }[] = [];
  const hold = { until: Promise.resolve() };
  const sweep = new Sweep({
    clock,
    everyMs: 1_000,
    members: () => members,
    visit: async (member) => {
      visits.push({ member, at: clock.now() - begun });
      await hold.until;
    },
  });
  const perMoment = (): number[] =>
    [...Map.groupBy(visits, ({ at }) => at).values()].map((v) => v.length);
  return { clock, members, visits, hold, sweep, perMoment };
}

it("visits the few of a small relay all at once, once in each period", async () => {
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
])("visits each of %i once in a period, and never more than %i in a turn", async (count, most) => {
  const { clock, visits, perMoment } = withMembers(count);
  await clock.pass(1_990);
  expect(visits.map(({ member }) => member)).toEqual(Array.from({ length: count }, (_, n) => n));
  expect(Math.max(...perMoment())).toBe(most);
  await clock.pass(1_000);
  expect(visits).toHaveLength(2 * count);
  const again = visits[count];
  expect(again).toEqual({ member: 0, at: 2_000 });
});

it("waits with the next sweep until what was done in this one is over", async () => {
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

it("takes no longer for all where each turn comes late", async () => {
  const { clock, visits } = withMembers(500);
  const after = clock.after.bind(clock);
  clock.after = (ms, call) => after(ms + 85, call);
  await clock.pass(1_000 + 800);
  expect(visits).toHaveLength(500);
});

it("begins no other sweep once it is closed while something is being done", async () => {
  const { clock, visits, hold, sweep } = withMembers(1);
  const { promise, resolve } = Promise.withResolvers<void>();
  hold.until = promise;
  await clock.pass(1_500);
  sweep.close();
  resolve();
  await clock.pass(10_000);
  expect(visits).toHaveLength(1);
});

it("visits nobody once it is closed, in the midst of a sweep as well", async () => {
  const { clock, visits, sweep } = withMembers(100);
  await clock.pass(1_015);
  expect(visits).toHaveLength(20);
  sweep.close();
  await clock.pass(10_000);
  expect(visits).toHaveLength(20);
});
