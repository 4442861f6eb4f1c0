import type { Progress } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { delayedPath, endOf } from "./path-ahead.ts";

const pose = { x: 650, y: 282, heading: 0 };

function progress(changes: Partial<Progress>): Progress {
  return {
    action: "move",
    part: 0,
    parts: 1,
    kind: "drive",
    direction: 1,
    left: 36,
    of: 50,
    ...changes,
  };
}

const delayed = { action: "delayed right 90", parts: 3 } as const;

describe("the path of a delayed turn", () => {
  it.each([
    {
      name: "leads to the turning point and out of the junction",
      changes: { ...delayed, left: 36 },
      points: [
        [650, 282],
        [650, 246],
        [735, 246],
      ],
    },
    {
      name: "leads to the left for a delayed left 90",
      changes: { action: "delayed left 90", parts: 3, left: 36 },
      points: [
        [650, 282],
        [650, 246],
        [565, 246],
      ],
    },
    {
      name: "points out of the junction while it turns",
      changes: { ...delayed, part: 1, kind: "turn", left: 90 },
      points: [
        [650, 282],
        [735, 282],
      ],
    },
    {
      name: "shrinks while it leaves",
      changes: { ...delayed, part: 2, left: 10 },
      points: [
        [650, 282],
        [650, 247],
      ],
    },
  ] satisfies { name: string; changes: Partial<Progress>; points: number[][] }[])(
    "$name",
    ({ changes, points }) => {
      const path = delayedPath(pose, progress(changes)) ?? [];
      expect(path).toHaveLength(points.length);
      path.forEach(({ x, y }, at) => {
        expect(x).toBeCloseTo(points[at]?.[0] ?? Number.NaN, 6);
        expect(y).toBeCloseTo(points[at]?.[1] ?? Number.NaN, 6);
      });
    },
  );

  it("is null for every other action", () => {
    expect(delayedPath(pose, null)).toBeNull();
    expect(delayedPath(pose, progress({}))).toBeNull();
  });
});

describe("the pose at which a command ends", () => {
  it.each([
    { name: "a drive", changes: { left: 100 }, end: { x: 650, y: 182, heading: 0 } },
    {
      name: "a drive back",
      changes: { left: 40, direction: -1 },
      end: { x: 650, y: 322, heading: 0 },
    },
    {
      name: "a turn",
      changes: { kind: "turn", left: 30, direction: -1 },
      end: { x: 650, y: 282, heading: -30 },
    },
  ] satisfies { name: string; changes: Partial<Progress>; end: object }[])(
    "$name",
    ({ changes, end }) => {
      expect(endOf(pose, progress(changes))).toEqual(end);
    },
  );

  it.each([
    { name: "nothing runs", running: null },
    { name: "wheels turn for a time", running: progress({ kind: "wheels" }) },
    { name: "a delayed turn has its own path", running: progress(delayed) },
  ])("is not drawn while $name", ({ running }) => {
    expect(endOf(pose, running)).toBeNull();
  });
});
