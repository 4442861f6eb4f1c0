/**
 * Opens the drawing of the stage: in the simulator worker, on transferred canvases, or on the page
 * in a browser without OffscreenCanvas. Both use the same renderer, which the page loads only in
 * the second case.
 */
import interFont from "../../ui/fonts/inter-latin.woff2?url";
import type { LayerCanvases } from "../drawing/drawing-context.ts";
import { modelChanges, type StageModel } from "../layers/stage-model.ts";
import type { Scroll } from "../drawing/viewport.ts";
import type { StageLink, StageScreen } from "./stage-screen.ts";

/**
 * @param holder receives new canvases on each call, because a canvas can be transferred only once
 * @param follow scrolls the stage so that the robot stays in view
 */
export function openStageScreen(
  simulator: StageLink,
  holder: HTMLElement,
  follow: (scroll: Scroll) => void,
): StageScreen {
  const canvases = {
    maze: document.createElement("canvas"),
    trail: document.createElement("canvas"),
    live: document.createElement("canvas"),
  };
  holder.replaceChildren(...Object.values(canvases));
  // Every browser that can transfer a canvas supports animation frames in workers.
  const screen =
    "OffscreenCanvas" in window && "transferControlToOffscreen" in HTMLCanvasElement.prototype
      ? openInWorker(simulator, canvases, follow)
      : openOnPage(simulator, canvases, follow);
  return {
    ...screen,
    end: () => {
      screen.end();
      holder.replaceChildren();
    },
  };
}

function openInWorker(
  simulator: StageLink,
  canvases: LayerCanvases<HTMLCanvasElement>,
  follow: (scroll: Scroll) => void,
): StageScreen {
  const transferred = {
    maze: canvases.maze.transferControlToOffscreen(),
    trail: canvases.trail.transferControlToOffscreen(),
    live: canvases.live.transferControlToOffscreen(),
  };
  simulator.send(
    { type: "stage-mount", canvases: transferred, font: new URL(interFont, location.href).href },
    Object.values(transferred),
  );
  const stop = simulator.listen((message) => {
    if (message.type === "stage-scroll-to") follow(message.scroll);
  });
  let shown: StageModel | null = null;
  return {
    show: (model) => {
      const changes = modelChanges(shown, model);
      shown = model;
      if (changes !== null) simulator.send({ type: "stage-model", changes });
    },
    end: () => {
      stop();
      simulator.send({ type: "stage-unmount" });
    },
  };
}

function openOnPage(
  simulator: StageLink,
  canvases: LayerCanvases<HTMLCanvasElement>,
  follow: (scroll: Scroll) => void,
): StageScreen {
  let screen: StageScreen | null = null;
  let isOver = false;
  let model: StageModel | null = null;
  void import("./page-stage.ts").then(({ openPageStage }) => {
    if (isOver) return;
    screen = openPageStage(simulator, canvases, follow);
    if (model !== null) screen.show(model);
  });
  return {
    show: (next) => {
      model = next;
      screen?.show(next);
    },
    end: () => {
      isOver = true;
      screen?.end();
    },
  };
}
