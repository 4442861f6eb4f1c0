/** The pose, for hosts that can measure it. */
import type { Pose } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { must } from "../mismatch.ts";
import { moveToStart } from "../pen.ts";

const TOLERANCE_DEGREES = 4;
const TOLERANCE_CM = 6;

export const pose: CheckGroup = {
  title: "Pose",
  checks: [
    {
      promise: "pose-heading",
      name: "`heading` is in degrees clockwise, from 0 up to 360",
      needs: ["pose"],
      run: async (host) => {
        const before = (await moveToStart(host)).pose.heading;
        for (const [degrees, action] of [
          [90, "right 90"],
          [0, "left 90"],
          [-90, "left 90"],
          [0, "right 90"],
        ] as const) {
          await host.sendAndWait({ action });
          const { heading } = (await host.snapshot()).pose;
          const wanted = (before + degrees + 360) % 360;
          must(apart(heading, wanted) < TOLERANCE_DEGREES, `a heading of ${wanted}`, heading);
        }
      },
    },
    {
      promise: "pose-axes",
      name: "`x` grows to the right and `y` downward, in cm",
      needs: ["pose"],
      run: async (host) => {
        let from = (await moveToStart(host)).pose;
        for (const distance of [60, -60]) {
          await host.sendAndWait({ action: "move", distance });
          const now = (await host.snapshot()).pose;
          mustBe(now, ahead(from, distance), `after move ${distance}`);
          from = now;
        }
      },
    },
    {
      promise: "pose-ending",
      name: "`pose` in a record is the pose of the robot when the command ended",
      needs: ["pose"],
      run: async (host) => {
        await moveToStart(host);
        for (const distance of [50, -50]) {
          const { pose: ended } = await host.sendAndWait({ action: "move", distance });
          must(ended !== null, "a pose in the record", ended);
          mustBe((await host.snapshot()).pose, ended, "in the snapshot after an ending");
        }
      },
    },
  ],
};

function ahead({ x, y, heading }: Pose, distance: number): Pose {
  const radians = (heading * Math.PI) / 180;
  return { x: x + Math.sin(radians) * distance, y: y - Math.cos(radians) * distance, heading };
}

function apart(a: number, b: number): number {
  const between = (a - b + 720) % 360;
  return Math.min(between, 360 - between);
}

function mustBe(found: Pose, wanted: Pose, when: string): void {
  const isThere =
    Math.hypot(found.x - wanted.x, found.y - wanted.y) < TOLERANCE_CM &&
    apart(found.heading, wanted.heading) < TOLERANCE_DEGREES;
  must(isThere, `the pose ${JSON.stringify(wanted)} ${when}`, found);
}
