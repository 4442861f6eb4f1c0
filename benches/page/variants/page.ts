/**
 * The page of the variants: `?variant=worker-layers|page-layers|svg&side=33`. Says `data-ready` on the
 * body once the trail is there and the robot drives.
 */
import type { MazeDocument } from "@corridor/maze";
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot } from "react-dom/client";
import { Drawing } from "./drawing.ts";
import { createPanel } from "./panel.ts";
import { PANEL_MS } from "./panel-rate.ts";
import type { News } from "./run.worker.ts";
import { STAGE_PX, type Shot } from "./scenery.ts";
import { SvgStage, TrailPieces } from "./svg-stage.ts";

const query = new URLSearchParams(location.search);
const variant = query.get("variant");
const side = Number(query.get("side"));
const stage = document.createElement("div");
stage.className = "stage";
document.body.append(stage);
const writePanel = createPanel();
const worker = new Worker(new URL("./run.worker.ts", import.meta.url), { type: "module" });

function newCanvas(): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = STAGE_PX;
  stage.append(canvas);
  return canvas;
}

function listen(on: (news: News) => void): void {
  worker.addEventListener("message", ({ data }: MessageEvent<News>) => {
    if (data.type === "ready") document.body.dataset["ready"] = "yes";
    on(data);
  });
}

/** Hands every frame's newest shot to the screen, and to the panel at its own rate. */
function drawOnPage(draw: (shot: Shot) => void): (shot: Shot) => void {
  let newest: Shot | null = null;
  let writtenAt = 0;
  const paint = (): void => {
    if (newest !== null) draw(newest);
    if (newest !== null && performance.now() - writtenAt >= PANEL_MS) {
      writtenAt = performance.now();
      writePanel(newest);
    }
    requestAnimationFrame(paint);
  };
  requestAnimationFrame(paint);
  return (shot) => (newest = shot);
}

switch (variant) {
  case "worker-layers": {
    const [maze, trail, live] = [newCanvas(), newCanvas(), newCanvas()].map((canvas) =>
      canvas.transferControlToOffscreen(),
    );
    listen((news) => {
      if (news.type === "shot") writePanel(news.shot);
    });
    worker.postMessage(
      { side, canvases: { maze, trail, live } },
      [maze, trail, live].filter((canvas) => canvas !== undefined),
    );
    break;
  }
  case "page-layers": {
    const [maze, trail, live] = [newCanvas(), newCanvas(), newCanvas()].map((canvas) =>
      canvas.getContext("2d"),
    );
    let drawing: Drawing | null = null;
    const show = drawOnPage((shot) => drawing?.draw(shot));
    listen((news) => {
      if (news.type === "shot") return show(news.shot);
      if (!maze || !trail || !live) throw new Error("no 2D canvas");
      drawing = new Drawing({ maze, trail, live }, news.maze, news.trail);
    });
    worker.postMessage({ side, canvases: null });
    break;
  }
  case "svg": {
    const root = createRoot(stage);
    let ready: { maze: MazeDocument; pieces: TrailPieces } | null = null;
    const show = drawOnPage((shot) => {
      if (ready === null) return;
      const { maze, pieces } = ready;
      // oxlint-disable-next-line react/no-flush-sync -- a frame is a frame: React must not put it off
      flushSync(() =>
        root.render(createElement(SvgStage, { maze, pieces: pieces.grown(shot), shot })),
      );
    });
    listen((news) => {
      if (news.type === "ready") ready = { maze: news.maze, pieces: new TrailPieces(news.trail) };
      else show(news.shot);
    });
    worker.postMessage({ side, canvases: null });
    break;
  }
  case null:
  default:
    throw new Error(`no such variant: ${String(variant)}`);
}
