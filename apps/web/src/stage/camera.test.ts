import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Camera } from "./camera.ts";
import { layOutFollowing, viewX, viewY, viewportAt } from "./drawing/viewport.ts";

const padding = { top: 16, right: 16, bottom: 16, left: 16 };
const view = { width: 390, height: 340 };
const large = layOutFollowing({ columns: 11, rows: 7 }, view, padding, 60);

const somewhere = fc.record({
  x: fc.double({ min: 25, max: 1075, noNaN: true }),
  y: fc.double({ min: 25, max: 675, noNaN: true }),
  heading: fc.constant(0),
});

describe("the camera that follows the robot", () => {
  it("centres the robot, far from the edges of the maze", () => {
    const scroll = new Camera().at(large, { x: 550, y: 350, heading: 0 }, false, 1);
    const viewport = viewportAt(large, scroll);
    expect([viewX(viewport, 550), viewY(viewport, 350)]).toEqual([195, 170]);
  });

  it.each([
    { name: "steadily", isCalm: false },
    { name: "by cuts", isCalm: true },
  ])("always shows the robot, and nothing beyond the maze's padding, $name", ({ isCalm }) => {
    fc.assert(
      fc.property(fc.array(somewhere, { minLength: 1 }), (poses) => {
        const camera = new Camera();
        for (const pose of poses) {
          const scroll = camera.at(large, pose, isCalm, 0.5);
          const viewport = viewportAt(large, scroll);
          const x = viewX(viewport, pose.x);
          const y = viewY(viewport, pose.y);
          expect(x >= 25 && x <= view.width - 25 && y >= 25 && y <= view.height - 25).toBe(true);
          expect(scroll.x >= 0 && scroll.x <= large.content.width - view.width).toBe(true);
          expect(scroll.y >= 0 && scroll.y <= large.content.height - view.height).toBe(true);
        }
      }),
    );
  });

  it("stands still until the robot comes near its edge if the user prefers reduced motion", () => {
    const camera = new Camera();
    const places = [500, 520, 540, 560].map((x) =>
      camera.at(large, { x, y: 350, heading: 90 }, true, 1),
    );
    expect(new Set(places).size).toBe(1);
    expect(camera.at(large, { x: 900, y: 350, heading: 90 }, true, 1)).not.toEqual(places[0]);
  });

  it("returns the same object while it stands still, so that nothing is repainted", () => {
    const camera = new Camera();
    const pose = { x: 550, y: 350, heading: 0 };
    const first = camera.at(large, pose, false, 0.5);
    expect(camera.at(large, { ...pose, heading: 90 }, false, 0.5)).toBe(first);
  });

  it("is not needed where the whole maze fits", () => {
    const small = layOutFollowing({ columns: 5, rows: 3 }, view, padding, 60);
    expect(small).toMatchObject({ follows: false, overflows: false });
    expect(small.cellPx).toBeGreaterThanOrEqual(60);
    expect(large).toMatchObject({ follows: true, overflows: false, cellPx: 60 });
  });
});
