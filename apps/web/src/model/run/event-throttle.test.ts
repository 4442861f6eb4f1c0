import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { createEventThrottle } from "./event-throttle.ts";

let lastTick = 0;
function eventOf(kind: RunEvent["kind"]): RunEvent {
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

/** A throttle with a clock that the test controls. */
function newThrottle() {
  let time = 1000;
  const timers: { at: number; run: () => void }[] = [];
  const shown: { at: number; event: RunEvent | null }[] = [];
  const throttle = createEventThrottle({
    show: (each) => void shown.push({ at: time, event: each }),
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
  return { ...throttle, pass, shown, events: () => shown.map((each) => each.event), timers };
}

describe("the throttle of run events", () => {
  it("shows the first bump at once", () => {
    const { push, events } = newThrottle();
    const bump = eventOf("bump");
    push(bump);
    expect(events()).toEqual([bump]);
  });

  it("shows 125 bumps a second at most twice a second, and the newest in the end", () => {
    const { push, pass, events } = newThrottle();
    const bumps = Array.from({ length: 250 }, () => eventOf("bump"));
    for (const bump of bumps) {
      push(bump);
      pass(8);
    }
    pass(500);
    expect(events()).toHaveLength(5);
    expect(events()[0]).toBe(bumps[0]);
    expect(events().at(-1)).toBe(bumps.at(-1));
  });

  it("shows a goal at once, and no older bump after it", () => {
    const { push, pass, events } = newThrottle();
    const [first, waiting, goal] = [eventOf("bump"), eventOf("bump"), eventOf("goal")];
    push(first);
    push(waiting);
    push(goal);
    expect(events()).toEqual([first, goal]);
    pass(2000);
    expect(events()).toEqual([first, goal]);
  });

  it("retains events before the tick from which the run continues differently", () => {
    const { push, truncate, pass, events } = newThrottle();
    const [first, later] = [eventOf("bump"), eventOf("bump")];
    push(first);
    push(later);
    truncate(first.tick);
    pass(2000);
    expect(events()).toEqual([first]);
    truncate(first.tick - 1);
    expect(events()).toEqual([first, null]);
  });

  it("shows no event of the previous run after a reset", () => {
    const { push, truncate, pass, events } = newThrottle();
    const [first, waiting, afterwards] = [eventOf("bump"), eventOf("bump"), eventOf("bump")];
    push(first);
    push(waiting);
    truncate(-1);
    pass(100);
    push(afterwards);
    pass(2000);
    expect(events()).toEqual([first, null, afterwards]);
  });

  it("limits the rate and ends with the newest event in every order", () => {
    const happening = fc.record({
      what: fc.constantFrom("bump", "bump", "bump", "goal", "clear"),
      wait: fc.integer({ min: 0, max: 700 }),
    });
    fc.assert(
      fc.property(fc.array(happening, { minLength: 1 }), (happenings) => {
        const { push, truncate, pass, shown, timers } = newThrottle();
        let newest: RunEvent | null = null;
        for (const { what, wait } of happenings) {
          newest = what === "clear" ? null : eventOf(what);
          if (newest === null) truncate(-1);
          else push(newest);
          expect(timers.length).toBeLessThanOrEqual(1);
          pass(wait);
        }
        pass(500);
        expect(shown.at(-1)?.event ?? null).toBe(newest);
        for (const [index, { at, event }] of shown.entries()) {
          const before = shown[index - 1];
          if (event?.kind !== "bump" || (before?.event ?? null) === null) continue;
          expect(at - (before?.at ?? 0)).toBeGreaterThanOrEqual(500);
        }
      }),
    );
  });
});
