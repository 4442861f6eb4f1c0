/**
 * Runs the robot for a variant. With canvases it draws them by itself and tells the page what its panel
 * shows; without, it sends every frame.
 */
import { Drawing } from "./drawing.ts";
import { PANEL_MS } from "./panel-rate.ts";
import { Scenery, type Shot } from "./scenery.ts";

interface Order {
  side: number;
  canvases: { maze: OffscreenCanvas; trail: OffscreenCanvas; live: OffscreenCanvas } | null;
}

export type News =
  | { type: "ready"; maze: Scenery["maze"]; trail: number[] }
  | { type: "shot"; shot: Shot };

const post = (news: News): void => self.postMessage(news);

self.addEventListener("message", ({ data }: MessageEvent<Order>) => {
  const scenery = new Scenery(data.side);
  const trail = scenery.runUp();
  post({ type: "ready", maze: scenery.maze, trail });
  const { canvases } = data;
  const drawing =
    canvases === null
      ? null
      : new Drawing(
          {
            maze: contextOf(canvases.maze),
            trail: contextOf(canvases.trail),
            live: contextOf(canvases.live),
          },
          scenery.maze,
          trail,
        );
  let toldAt = 0;
  const paint = (): void => {
    const shot = scenery.step();
    drawing?.draw(shot);
    if (drawing === null || performance.now() - toldAt >= PANEL_MS) {
      toldAt = performance.now();
      post({ type: "shot", shot });
    }
    requestAnimationFrame(paint);
  };
  requestAnimationFrame(paint);
});

function contextOf(canvas: OffscreenCanvas): OffscreenCanvasRenderingContext2D {
  const context = canvas.getContext("2d");
  if (context === null) throw new Error("no 2D canvas");
  return context;
}
