import { snapshotSchema, TICKS_PER_SECOND, type Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
  centimetres,
  degreesOf,
  rosPose,
  sinCos,
  stampOf,
  velocityBetween,
  WHEEL_SPEED,
  wheelPowers,
} from "./conversions.ts";
import { RosClient } from "./testing/ros-client.ts";
import { topics } from "./topics.ts";

/** cm; the largest maze has 256 cells a side */
const length = fc.double({ min: -25_600, max: 25_600, noNaN: true });
const reading = fc.double({ min: 0, max: 2 * 25_600, noNaN: true });
const heading = fc.double({ min: 0, max: 360, maxExcluded: true, noNaN: true });
const pose = fc.record({ x: length, y: length, heading });
const height = fc.integer({ min: 1, max: 256 }).map((rows) => rows * 100);
const finite = fc.double({ noNaN: true, noDefaultInfinity: true });

/** Any snapshot that a robot may report. */
const snapshot: fc.Arbitrary<Snapshot> = fc
  .record({
    tick: fc.nat({ max: Number.MAX_SAFE_INTEGER }),
    pose,
    sensors: fc.record({ front: reading, right: reading, back: reading, left: reading }),
    bumping: fc.boolean(),
  })
  .map((change) => snapshotSchema.parse(snapshotOf(change)));

describe("a pose", () => {
  it("is the same after a conversion to metres and back", () => {
    fc.assert(
      fc.property(pose, height, (from, cm) => {
        const { x, y, theta, orientation } = rosPose(from, cm);
        expect(centimetres(x)).toBeCloseTo(from.x, 6);
        expect(cm - centimetres(y)).toBeCloseTo(from.y, 6);
        const turned = Math.abs(90 - degreesOf(theta) - from.heading) % 360;
        expect(Math.min(turned, 360 - turned)).toBeCloseTo(0, 6);
        expect(theta).toBeGreaterThan(-Math.PI);
        expect(theta).toBeLessThanOrEqual(Math.PI);
        const { x: qx, y: qy, z, w } = orientation;
        expect([qx, qy]).toEqual([0, 0]);
        expect(z * z + w * w).toBeCloseTo(1, 9);
        // By the half angle.
        const [sin, cos] = sinCos(degreesOf(theta));
        expect(2 * z * w).toBeCloseTo(sin, 6);
        expect(w * w - z * z).toBeCloseTo(cos, 6);
      }),
    );
  });
});

describe("a stamp", () => {
  it("shows each tick, with less than a second of nanoseconds", () => {
    fc.assert(
      fc.property(fc.nat({ max: 1e12 }), (tick) => {
        const { sec, nanosec, secs, nsecs } = stampOf(tick);
        expect([secs, nsecs]).toEqual([sec, nanosec]);
        expect(nanosec).toBeLessThan(1e9);
        expect(Math.round(sec * TICKS_PER_SECOND + (nanosec * TICKS_PER_SECOND) / 1e9)).toBe(tick);
      }),
    );
  });
});

describe("a velocity", () => {
  it("becomes powers within full power, of the same ratio", () => {
    fc.assert(
      fc.property(finite, finite, (linear, angular) => {
        const { left, right } = wheelPowers({ linear, angular });
        expect(Math.abs(left)).toBeLessThanOrEqual(1);
        expect(Math.abs(right)).toBeLessThanOrEqual(1);
      }),
    );
  });

  it("that the wheels reach is the same after a conversion to powers and back", () => {
    const speed = fc.double({ min: -1, max: 1, noNaN: true });
    fc.assert(
      fc.property(speed, speed, (linear, angular) => {
        const { left, right } = wheelPowers({ linear, angular });
        expect(((left + right) / 2) * WHEEL_SPEED).toBeCloseTo(linear, 9);
        expect(((right - left) / 0.4) * WHEEL_SPEED).toBeCloseTo(angular, 9);
      }),
    );
  });

  it("between two poses is finite", () => {
    fc.assert(
      fc.property(pose, pose, fc.integer({ min: 1, max: 60 }), (from, to, ticks) => {
        const { linear, angular } = velocityBetween(from, to, ticks);
        expect(Number.isFinite(linear) && Number.isFinite(angular)).toBe(true);
      }),
    );
  });
});

describe("a message of any topic", () => {
  it("has no infinite number and no NaN, whatever the robot reports", async () => {
    await fc.assert(
      fc.asyncProperty(snapshot, snapshot, fc.boolean(), async (first, second, hasMaze) => {
        const client = await RosClient.connect("drive", hasMaze);
        client.port.report(first);
        client.port.report(second);
        for (const topic of Object.keys(topics)) {
          if (topic !== "/corridor/snapshot") await client.send({ op: "subscribe", topic });
        }
        expect(client.frames.length).toBeGreaterThan(10);
        // Infinity and NaN are null in JSON.
        expect(JSON.stringify(client.frames)).not.toContain("null");
      }),
      { numRuns: 50 },
    );
  });

  it.each(Object.keys(topics).filter((topic) => topic !== "/rosout"))(
    "%s is the same by a name without a slash",
    async (topic) => {
      const client = await RosClient.connect();
      await client.send({ op: "subscribe", topic });
      await client.send({ op: "subscribe", topic: topic.slice(1), id: "other" });
      await client.timers.pass(50);
      const [message] = client.received(topic);
      expect(message).toBeDefined();
      expect(client.received(topic.slice(1))).toEqual([message]);
    },
  );
});
