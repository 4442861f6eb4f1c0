import { Timeline } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { pictureOf } from "./picture.ts";
import { axisOf, scaleOf, tickAt, xOf } from "./time-scale.ts";
import { following, holds, movedTo, zoomedBy, type Zoomed } from "./zoom-window.ts";

const MINUTE = 3600;
const width = 300;
const whole: Zoomed = { window: null, endTick: 104 * MINUTE, width };

/** A run of 104 minutes by line 1, with a turn each second. */
function longRun(): Timeline {
  const timeline = new Timeline();
  timeline.recordDriver(0, 0);
  for (let tick = 60; tick < 104 * MINUTE; tick += 60) {
    timeline.recordEvent({ kind: "turn", turn: "left 90", tick, driver: 0 });
  }
  timeline.advanceTo(104 * MINUTE);
  return timeline;
}

describe("a zoomed timeline", () => {
  it("of a run of 104 minutes shows single turns, and counts those in one mark of the whole", () => {
    const run = longRun();
    const [mark] = pictureOf(run, width).marks;
    expect(mark?.more).toBeGreaterThan(100);
    let window = null;
    for (let press = 0; press < 10; press++) {
      window = zoomedBy({ ...whole, window }, 2, 60 * MINUTE, 0.5);
    }
    const { marks, axis } = pictureOf(run, width, window);
    expect(marks.map(({ more }) => more)).toEqual(marks.map(() => 0));
    expect(marks.length).toBeGreaterThan(3);
    expect(axis.length).toBeGreaterThan(2);
  });

  it("is the whole run again when it is zoomed out", () => {
    const near = zoomedBy(whole, 2, 0, 0);
    expect(near).not.toBeNull();
    expect(zoomedBy({ ...whole, window: near }, 0.5, 0, 0)).toBeNull();
  });

  it("follows a moment that leaves it, and stays where it is for one that it holds", () => {
    const window = zoomedBy(whole, 16, 0, 0);
    expect(following({ ...whole, window }, 60)).toBe(window);
    const later = following({ ...whole, window }, 90 * MINUTE);
    expect(later !== null && holds(later, 90 * MINUTE)).toBe(true);
  });

  it("lies within the run, leaves the place under the pointer, and its times have room", () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 1, max: 200 * MINUTE }),
        fc.integer({ min: 60, max: 1200 }),
        fc.array(
          fc.tuple(
            fc.double({ min: 0.3, max: 4, noNaN: true }),
            fc.double({ min: 0, max: 1, noNaN: true }),
          ),
        ),
        fc.integer(),
        (endTick, wide, zooms, by) => {
          const all = scaleOf(endTick, wide).span;
          let window: Zoomed["window"] = null;
          for (const [factor, share] of zooms) {
            const scale = window ?? { from: 0, span: all };
            window = zoomedBy(
              { window, endTick, width: wide },
              factor,
              scale.from + share * scale.span,
              share,
            );
          }
          window = movedTo({ window, endTick, width: wide }, by);
          if (window === null) return;
          expect(window.from).toBeGreaterThanOrEqual(0);
          expect(window.from + window.span).toBeLessThanOrEqual(all + 1);
          const scale = { ...window, width: wide, isPart: true };
          const axis = axisOf(scale);
          for (const [index, { x }] of axis.entries()) {
            expect(x - (axis[index - 1]?.x ?? -100)).toBeGreaterThan(Math.min(55, wide - 1));
          }
          const middle = tickAt(scale, wide / 2);
          expect(Math.abs(xOf(scale, middle) - wide / 2)).toBeLessThanOrEqual(
            wide / window.span + 0.1,
          );
        },
      ),
    );
  });
});
