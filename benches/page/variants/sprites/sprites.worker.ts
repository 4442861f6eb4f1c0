/** The limit of the dashboard: one canvas, on which a worker draws sprites in every frame. */

export interface SpritesMessage {
  canvas: OffscreenCanvas;
  count: number;
}

/** Sides of a sprite and of its part of the canvas, in pixels. */
const SPRITE_PX = 24;
const PART_PX = 200;

self.addEventListener("message", ({ data }: MessageEvent<SpritesMessage>) => {
  const { canvas, count } = data;
  const context = canvas.getContext("2d");
  const sprite = new OffscreenCanvas(SPRITE_PX, SPRITE_PX);
  const pen = sprite.getContext("2d");
  if (context === null || pen === null) throw new Error("no 2D canvas");
  pen.fillStyle = "#ef6a1a";
  pen.arc(SPRITE_PX / 2, SPRITE_PX / 2, SPRITE_PX / 2, 0, 2 * Math.PI);
  pen.fill();
  const columns = Math.floor(canvas.width / PART_PX);
  let frame = 0;
  const paint = (): void => {
    const before = frame++ % (PART_PX - SPRITE_PX);
    const now = frame % (PART_PX - SPRITE_PX);
    for (let at = 0; at < count; at++) {
      const x = (at % columns) * PART_PX;
      const y = Math.floor(at / columns) * PART_PX;
      context.clearRect(x + before, y, SPRITE_PX, SPRITE_PX);
      context.drawImage(sprite, x + now, y);
    }
    requestAnimationFrame(paint);
  };
  requestAnimationFrame(paint);
  self.postMessage({ type: "ready" });
});
