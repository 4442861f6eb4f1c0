/**
 * The page of the variants: `?variant=worker-layers|page-layers|svg&side=33`. Sets `data-ready` on
 * the body when the trail is complete and the robot drives.
 */
import type { MazeDocument } from "@corridor/maze";
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot } from "react-dom/client";
import { Drawing } from "./drawing.ts";
import { createPanel } from "./panel.ts";
import { PANEL_MS } from "./panel-rate.ts";
import type { WorkerMessage } from "./run.worker.ts";
import { STAGE_PX, type RunFrame } from "./bench-run.ts";
import { SvgStage, TrailPieces } from "./svg-stage.ts";

const query = new URLSearchParams(location.search);
const variant = query.get("variant");
const side = Number(query.get("side"));
const stage = document.createElement("div");
stage.className = "stage";
document.body.append(stage);
const updatePanel = createPanel();
const worker = new Worker(new URL("./run.worker.ts", import.meta.url), { type: "module" });

function appendCanvas(): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = STAGE_PX;
  stage.append(canvas);
  return canvas;
}

function onWorkerMessage(listener: (message: WorkerMessage) => void): void {
  worker.addEventListener("message", ({ data }: MessageEvent<WorkerMessage>) => {
    if (data.type === "ready") document.body.dataset["ready"] = "yes";
    listener(data);
  });
}

/** Draws the latest run frame in every animation frame, and updates the panel at its own rate. */
function drawOnPage(draw: (frame: RunFrame) => void): (frame: RunFrame) => void {
  let latest: RunFrame | null = null;
  let panelUpdatedAt = 0;
  const paint = (): void => {
    if (latest !== null) draw(latest);
    if (latest !== null && performance.now() - panelUpdatedAt >= PANEL_MS) {
      panelUpdatedAt = performance.now();
      updatePanel(latest);
    }
    requestAnimationFrame(paint);
  };
  requestAnimationFrame(paint);
  return (frame) => (latest = frame);
}

switch (variant) {
  case "worker-layers": {
    const [maze, trail, live] = [appendCanvas(), appendCanvas(), appendCanvas()].map((canvas) =>
      canvas.transferControlToOffscreen(),
    );
    onWorkerMessage((message) => {
      if (message.type === "frame") updatePanel(message.frame);
    });
    worker.postMessage(
      { side, canvases: { maze, trail, live } },
      [maze, trail, live].filter((canvas) => canvas !== undefined),
    );
    break;
  }
  case "page-layers": {
    const [maze, trail, live] = [appendCanvas(), appendCanvas(), appendCanvas()].map((canvas) =>
      canvas.getContext("2d"),
    );
    let drawing: Drawing | null = null;
    const setFrame = drawOnPage((frame) => drawing?.draw(frame));
    onWorkerMessage((message) => {
      if (message.type === "frame") return setFrame(message.frame);
      if (!maze || !trail || !live) throw new Error("no 2D canvas");
      drawing = new Drawing({ maze, trail, live }, message.maze, message.trail);
    });
    worker.postMessage({ side, canvases: null });
    break;
  }
  case "svg": {
    const root = createRoot(stage);
    let ready: { maze: MazeDocument; pieces: TrailPieces } | null = null;
    const setFrame = drawOnPage((frame) => {
      if (ready === null) return;
      const { maze, pieces } = ready;
      // oxlint-disable-next-line react/no-flush-sync -- React must render within this frame
      flushSync(() =>
        root.render(createElement(SvgStage, { maze, pieces: pieces.append(frame), frame })),
      );
    });
    onWorkerMessage((message) => {
      if (message.type === "ready")
        ready = { maze: message.maze, pieces: new TrailPieces(message.trail) };
      else setFrame(message.frame);
    });
    worker.postMessage({ side, canvases: null });
    break;
  }
  case null:
  default:
    throw new Error(`no such variant: ${String(variant)}`);
}
