/**
 * Draws the stage on the page's main thread, where the browser cannot transfer canvases to a
 * worker.
 */
import type { LayerCanvases } from "../drawing/drawing-context.ts";
import { lateMarks } from "../layers/late-marks.ts";
import { loadRaceGhosts, raceGhostsLayer } from "../layers/lazy-race-ghosts.ts";
import { StageRenderer } from "../renderer.ts";
import type { Scroll } from "../drawing/viewport.ts";
import { FrameBuffer } from "../frame-buffer.ts";
import type { StageLink, StageScreen } from "./stage-screen.ts";

/** @param follow scrolls the stage so that the robot stays in view */
export function openPageStage(
  simulator: StageLink,
  canvases: LayerCanvases<HTMLCanvasElement>,
  follow: (scroll: Scroll) => void,
): StageScreen {
  const frames = new FrameBuffer();
  const renderer = new StageRenderer({
    takeFrame: () => frames.take(),
    requestFrame: (paint) => requestAnimationFrame(paint),
    cancelFrame: (request) => cancelAnimationFrame(request),
    now: () => performance.now(),
    scrollTo: follow,
  });
  renderer.attach(canvases);
  const stop = simulator.listen((message) => {
    if (message.type === "frame") renderer.showNumbersOf(message.frame.snapshot);
    if (message.type !== "picture") return;
    frames.add(message.frame);
    if (message.frame.ghosts !== undefined && raceGhostsLayer() === null) {
      // If the ghosts fail to load, they are not drawn; the next frame tries again.
      loadRaceGhosts().then(
        () => renderer.repaint(),
        () => undefined,
      );
    }
    if (message.frame.marks !== undefined && lateMarks.draw === null) {
      import("../layers/marks.ts").then(
        ({ drawMarks }) => {
          lateMarks.draw = drawMarks;
          renderer.repaint();
        },
        () => undefined,
      );
    }
    renderer.frameArrived(message.frame);
  });
  const onFont = (): void => renderer.fontLoaded();
  document.fonts.addEventListener("loadingdone", onFont);
  simulator.send({ type: "stage-mount-here" });
  return {
    show: (model) => renderer.show(model),
    end: () => {
      stop();
      document.fonts.removeEventListener("loadingdone", onFont);
      renderer.detach();
      simulator.send({ type: "stage-unmount" });
    },
  };
}
