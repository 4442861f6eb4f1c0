/**
 * Runs the robot for a variant. With canvases, it draws every frame and posts frames at the rate of
 * the panel. Without canvases, it posts every frame.
 */
import { Drawing } from "./drawing.ts";
import { PANEL_MS } from "./panel-rate.ts";
import { BenchRun, type RunFrame } from "./bench-run.ts";

interface StartMessage {
  side: number;
  canvases: { maze: OffscreenCanvas; trail: OffscreenCanvas; live: OffscreenCanvas } | null;
}

export type WorkerMessage =
  | { type: "ready"; maze: BenchRun["maze"]; trail: number[] }
  | { type: "frame"; frame: RunFrame };

const post = (message: WorkerMessage): void => self.postMessage(message);

self.addEventListener("message", ({ data }: MessageEvent<StartMessage>) => {
  const run = new BenchRun(data.side);
  const trail = run.driveTrail();
  post({ type: "ready", maze: run.maze, trail });
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
          run.maze,
          trail,
        );
  let postedAt = 0;
  const paint = (): void => {
    const frame = run.step();
    drawing?.draw(frame);
    if (drawing === null || performance.now() - postedAt >= PANEL_MS) {
      postedAt = performance.now();
      post({ type: "frame", frame });
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
