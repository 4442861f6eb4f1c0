import { expect, it } from "vitest";
import { HelpAnnouncer } from "./help-announcer.ts";

/** An announcer with a clock, and what it announced when. */
function newAnnouncer() {
  let now = 0;
  const timers = new Map<() => void, number>();
  const said: { at: number; students: readonly number[] }[] = [];
  const announcer = new HelpAnnouncer({
    announce: (students) => said.push({ at: now, students }),
    now: () => now,
    later: (call, ms) => {
      timers.set(call, now + ms);
      return () => timers.delete(call);
    },
  });
  const pass = (ms: number): void => {
    now += ms;
    for (const [call, at] of timers) {
      if (at > now) continue;
      timers.delete(call);
      call();
    }
  };
  return {
    timers,
    said,
    pass,
    help: (...students: number[]) => announcer.follow(new Set(students)),
  };
}

it("the first student who needs help is announced at once, others in 10 s, together", () => {
  const { said, pass, help } = newAnnouncer();
  help(1);
  pass(0);
  help(1, 2);
  pass(5_000);
  help(1, 2, 3);
  pass(5_000);
  expect(said).toEqual([
    { at: 0, students: [1] },
    { at: 10_000, students: [2, 3] },
  ]);
});

it("no timer runs while there is nothing to announce", () => {
  const { timers, pass, help } = newAnnouncer();
  help();
  expect(timers.size).toBe(0);
  help(1);
  pass(0);
  help(1);
  expect(timers.size).toBe(0);
  help(1, 2);
  help(1);
  expect(timers.size).toBe(0);
});

it("a student who needs help again is announced again", () => {
  const { said, pass, help } = newAnnouncer();
  help(1);
  pass(0);
  help();
  help(1);
  pass(10_000);
  expect(said.map(({ students }) => students)).toEqual([[1], [], [1]]);
});
