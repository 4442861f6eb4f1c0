import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { Moment } from "../worker/worker-messages.ts";
import { createMomentTeller } from "./moment-teller.ts";

let lastTick = 0;
function moment(kind: Moment["kind"]): Moment {
  const pose = { x: 150, y: 150, heading: 0 };
  return {
    kind,
    tick: ++lastTick,
    pose,
    line: null,
    driver: "program",
    bumps: 1,
    cause: null,
    diagnosis: null,
    program: null,
  };
}

/** A teller whose time passes when the test says so. */
function tellerInTime() {
  let time = 1000;
  const timers: { at: number; run: () => void }[] = [];
  const shown: { at: number; moment: Moment | null }[] = [];
  const teller = createMomentTeller({
    show: (each) => void shown.push({ at: time, moment: each }),
    now: () => time,
    later: (run, milliseconds) => void timers.push({ at: time + milliseconds, run }),
  });
  const pass = (milliseconds: number) => {
    const end = time + milliseconds;
    for (;;) {
      const next = timers.toSorted((a, b) => a.at - b.at)[0];
      if (next === undefined || next.at > end) break;
      timers.splice(timers.indexOf(next), 1);
      time = next.at;
      next.run();
    }
    time = end;
  };
  return { ...teller, pass, shown, moments: () => shown.map((each) => each.moment), timers };
}

describe("the story of a run", () => {
  it("tells the first bump at once", () => {
    const { tell, moments } = tellerInTime();
    const bump = moment("bump");
    tell(bump);
    expect(moments()).toEqual([bump]);
  });

  it("tells 125 bumps a second at most twice a second, and the newest in the end", () => {
    const { tell, pass, moments } = tellerInTime();
    const bumps = Array.from({ length: 250 }, () => moment("bump"));
    for (const bump of bumps) {
      tell(bump);
      pass(8);
    }
    pass(500);
    expect(moments()).toHaveLength(5);
    expect(moments()[0]).toBe(bumps[0]);
    expect(moments().at(-1)).toBe(bumps.at(-1));
  });

  it("tells a goal at once, and no older bump after it", () => {
    const { tell, pass, moments } = tellerInTime();
    const [first, waiting, goal] = [moment("bump"), moment("bump"), moment("goal")];
    tell(first);
    tell(waiting);
    tell(goal);
    expect(moments()).toEqual([first, goal]);
    pass(2000);
    expect(moments()).toEqual([first, goal]);
  });

  it("keeps what came before the moment from which the run goes on in another way", () => {
    const { tell, forgetAfter, pass, moments } = tellerInTime();
    const [first, later] = [moment("bump"), moment("bump")];
    tell(first);
    tell(later);
    forgetAfter(first.tick);
    pass(2000);
    expect(moments()).toEqual([first]);
    forgetAfter(first.tick - 1);
    expect(moments()).toEqual([first, null]);
  });

  it("tells nothing of the run before when the robot is back at its start", () => {
    const { tell, forgetAfter, pass, moments } = tellerInTime();
    const [first, waiting, afterwards] = [moment("bump"), moment("bump"), moment("bump")];
    tell(first);
    tell(waiting);
    forgetAfter(-1);
    pass(100);
    tell(afterwards);
    pass(2000);
    expect(moments()).toEqual([first, null, afterwards]);
  });

  it("keeps its pace and ends with the newest whatever happens when", () => {
    const happening = fc.record({
      what: fc.constantFrom("bump", "bump", "bump", "goal", "clear"),
      wait: fc.integer({ min: 0, max: 700 }),
    });
    fc.assert(
      fc.property(fc.array(happening, { minLength: 1 }), (happenings) => {
        const { tell, forgetAfter, pass, shown, timers } = tellerInTime();
        let newest: Moment | null = null;
        for (const { what, wait } of happenings) {
          newest = what === "clear" ? null : moment(what);
          if (newest === null) forgetAfter(-1);
          else tell(newest);
          expect(timers.length).toBeLessThanOrEqual(1);
          pass(wait);
        }
        pass(500);
        expect(shown.at(-1)?.moment ?? null).toBe(newest);
        for (const [index, { at, moment: told }] of shown.entries()) {
          const before = shown[index - 1];
          if (told?.kind !== "bump" || (before?.moment ?? null) === null) continue;
          expect(at - (before?.at ?? 0)).toBeGreaterThanOrEqual(500);
        }
      }),
    );
  });
});
