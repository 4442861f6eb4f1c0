/** The page of the limit of the dashboard: `?count=40`. It fills the window with one canvas. */
import type { SpritesMessage } from "./sprites.worker.ts";

const canvas = document.createElement("canvas");
canvas.width = window.innerWidth;
canvas.height = window.innerHeight;
canvas.style.cssText = "position: fixed; inset: 0";
document.body.append(canvas);
const worker = new Worker(new URL("./sprites.worker.ts", import.meta.url), { type: "module" });
worker.addEventListener("message", () => {
  document.body.dataset["ready"] = "yes";
});
const offscreen = canvas.transferControlToOffscreen();
const count = Number(new URLSearchParams(location.search).get("count"));
const message: SpritesMessage = { canvas: offscreen, count };
worker.postMessage(message, [offscreen]);
