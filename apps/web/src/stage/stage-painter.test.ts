import { describe, expect, it } from "vitest";
import { StagePainter } from "./stage-painter.ts";
import { frameOf } from "./testing/frame-of.ts";
import type { StageFromWorker } from "./stage-messages.ts";

/** A painter whose animation frames run when the test requests them. */
function newPainter() {
  const posted: StageFromWorker[] = [];
  const waiting: (() => void)[] = [];
  const counts = { caughtUp: 0, fonts: 0 };
  const painter: StagePainter = new StagePainter({
    post: (message) => posted.push(message),
    requestFrame: (paint) => waiting.push(paint),
    cancelFrame: () => waiting.splice(0),
    catchUp: () => {
      counts.caughtUp++;
    },
    loadFont: () => {
      counts.fonts++;
      return Promise.resolve();
    },
  });
  return { painter, posted, waiting, counts };
}

describe("a stage that the page draws by itself", () => {
  it("receives every frame, and first the missed ones", () => {
    const { painter, posted, waiting } = newPainter();
    painter.add(frameOf({ corners: [1, 2], trailReset: true }));
    painter.add(frameOf({ corners: [3, 4] }));
    expect(posted).toEqual([]);
    painter.handle({ type: "stage-mount-here" });
    painter.add(frameOf({ corners: [5, 6] }));
    expect(posted).toMatchObject([
      { type: "picture", frame: { corners: [1, 2, 3, 4], trailReset: true } },
      { type: "picture", frame: { corners: [5, 6], trailReset: false } },
    ]);
    expect(waiting).toHaveLength(0);
  });

  it("receives nothing after it is unmounted", () => {
    const { painter, posted } = newPainter();
    painter.handle({ type: "stage-mount-here" });
    painter.handle({ type: "stage-unmount" });
    painter.add(frameOf());
    expect(posted).toEqual([]);
  });
});

describe("a stage without canvases", () => {
  it("requests no animation frame, however much the robot drives", () => {
    const { painter, waiting, counts } = newPainter();
    painter.add(frameOf());
    painter.handle({ type: "stage-model", changes: { scroll: { x: 10, y: 0 } } });
    expect(waiting).toHaveLength(0);
    expect(counts.caughtUp).toBe(0);
  });
});
