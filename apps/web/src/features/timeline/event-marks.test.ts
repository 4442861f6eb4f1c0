import { Timeline, type TimelineEvent } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { marksOf, markUnder } from "./event-marks.ts";
import { scaleOf } from "./time-scale.ts";

const width = 480;
const turn = (tick: number): TimelineEvent => ({ kind: "turn", turn: "left 90", tick, driver: 0 });
const bump = (tick: number): TimelineEvent => ({ kind: "bump", tick, driver: 1 });
const goal = (tick: number): TimelineEvent => ({ kind: "goal", tick, driver: 0 });

function marksOfRun(...events: TimelineEvent[]) {
  const timeline = new Timeline();
  for (const event of events.toSorted((a, b) => a.tick - b.tick)) {
    timeline.recordEvent(event);
    timeline.advanceTo(event.tick);
  }
  return marksOf(timeline, scaleOf(timeline.endTick, width));
}

const ticks = (marks: ReturnType<typeof marksOf>) => marks.map(({ event }) => event.tick);

describe("the marks of events", () => {
  it("stand where their events happened", () => {
    const marks = marksOfRun(bump(150), turn(300), goal(1_500));
    expect(marks.map(({ event, x }) => [event.kind, x])).toEqual([
      ["bump", 40],
      ["turn", 80],
      ["goal", 400],
    ]);
  });

  it.each([
    { name: "a bump after a turn", events: [turn(300), bump(330)], shown: [330] },
    { name: "a bump before a turn", events: [bump(300), turn(330)], shown: [300] },
    { name: "the goal after a bump", events: [bump(300), goal(340)], shown: [340] },
    { name: "the first of turns", events: [turn(300), turn(330), turn(350)], shown: [300] },
    {
      name: "a bump that hides a turn, and not the one after it",
      events: [turn(300), bump(340), turn(380), turn(420)],
      shown: [340, 420],
    },
  ])("show $name where there is room for one", ({ events, shown }) => {
    expect(ticks(marksOfRun(...events))).toEqual(shown);
  });

  it("never overlap, and hide no goal", () => {
    const anyEvent = fc
      .tuple(fc.constantFrom(turn, bump), fc.integer({ min: 1, max: 3_000 }))
      .map(([make, tick]) => make(tick));
    fc.assert(
      fc.property(fc.array(anyEvent), fc.integer({ min: 1, max: 3_000 }), (events, at) => {
        const marks = marksOfRun(...events, goal(at));
        for (const [index, { x }] of marks.entries()) {
          const before = marks[index - 1]?.x ?? -15;
          expect(x - before).toBeGreaterThanOrEqual(14.8);
        }
        expect(ticks(marks.filter(({ event }) => event.kind === "goal"))).toEqual([at]);
      }),
    );
  });

  it("are found by the pointer above them", () => {
    const marks = marksOfRun(bump(150), turn(300));
    expect(markUnder(marks, 45)?.event.kind).toBe("bump");
    expect(markUnder(marks, 60)).toBeNull();
    expect(markUnder(marks, 74)?.event.kind).toBe("turn");
  });
});
