/**
 * Draws the stage in the worker, directly from the run's newest state, on canvases that the page
 * has transferred. The main thread takes no part in a frame. Browsers without transferable canvases
 * draw in the page, which receives every frame.
 *
 * The worker of a hidden page receives no animation frames: nothing is drawn then, and the next
 * frame shows the newest state.
 */
import { StageRenderer } from "./renderer.ts";
import type { Palette } from "./drawing/palette.ts";
import type { StageModel } from "./layers/stage-model.ts";
import { FrameBuffer } from "./frame-buffer.ts";
import type { StageFromWorker, StageToWorker } from "./stage-messages.ts";
import type { Frame } from "./drawing/frame.ts";

/**
 * The page's font under its own name: a canvas that has drawn with a fallback uses it as long as
 * the font's name stays the same.
 */
const STAGE_FONT = "Corridor Stage";

export interface StagePainterPort {
  post: (message: StageFromWorker) => void;
  requestFrame: (paint: () => void) => number;
  cancelFrame: (request: number) => void;
  /** brings the run up to now, immediately before it is drawn; may `add` a frame */
  catchUp: () => void;
  /** Registers a font file under a name. */
  loadFont: (name: string, address: string) => Promise<void>;
}

export class StagePainter {
  readonly #port: StagePainterPort;
  readonly #frames = new FrameBuffer();
  readonly #renderer: StageRenderer;
  #model: StageModel | null = null;
  #isPageDrawing = false;
  #font: string | null = null;
  #hasFont = false;
  /** the newest palette as received, and with the loaded font */
  #plain: Palette | null = null;
  #inFont: Palette | null = null;

  constructor(port: StagePainterPort) {
    this.#port = port;
    this.#renderer = new StageRenderer({
      takeFrame: () => {
        port.catchUp();
        return this.#frames.take();
      },
      requestFrame: port.requestFrame,
      cancelFrame: port.cancelFrame,
      now: () => performance.now(),
      scrollTo: (scroll) => port.post({ type: "stage-scroll-to", scroll }),
    });
  }

  /** Adds the newest frame of the run. */
  add(frame: Frame): void {
    this.#frames.add(frame);
    if (this.#isPageDrawing) {
      this.#post();
      return;
    }
    this.#renderer.frameArrived(frame);
  }

  handle(message: StageToWorker): void {
    switch (message.type) {
      case "stage-mount":
        this.#isPageDrawing = false;
        this.#renderer.attach(message.canvases);
        this.#useFont(message.font);
        return;
      case "stage-mount-here":
        this.#isPageDrawing = true;
        this.#post();
        return;
      case "stage-model":
        // The first message after a mount is complete.
        this.#model = { ...this.#model, ...message.changes } as StageModel;
        this.#show();
        return;
      case "stage-numbers":
        this.#renderer.showNumbersOf(message.snapshot);
        return;
      case "stage-unmount":
        this.#isPageDrawing = false;
        this.#renderer.detach();
        return;
    }
  }

  #post(): void {
    const frame = this.#frames.take();
    if (frame !== null) this.#port.post({ type: "picture", frame });
  }

  #show(): void {
    const model = this.#model;
    if (model === null) return;
    if (!this.#hasFont) return this.#renderer.show(model);
    if (model.palette !== this.#plain) {
      this.#plain = model.palette;
      this.#inFont = { ...model.palette, font: `"${STAGE_FONT}", ${model.palette.font}` };
    }
    this.#renderer.show({ ...model, palette: this.#inFont ?? model.palette });
  }

  /** Text is drawn in the fallback font until the page's font has loaded, and redrawn then. */
  #useFont(address: string): void {
    if (this.#font === address) return;
    this.#font = address;
    this.#port.loadFont(STAGE_FONT, address).then(
      () => {
        this.#hasFont = true;
        this.#show();
      },
      // The fallback font stays.
      () => {},
    );
  }
}
