/** Messages to and from the site around the page. */
import { readFrameRequest, type FrameReport, type FrameRequest } from "@corridor/protocol";

/** The part of the window that is used. */
export interface FrameWindow {
  /** the window itself if the page is in no frame */
  parent: object & Pick<Window, "postMessage">;
  addEventListener: (
    type: "message",
    listener: (event: Pick<MessageEvent<unknown>, "source" | "data">) => void,
  ) => void;
}

export class FramePort {
  readonly #window: FrameWindow;

  constructor(window: FrameWindow) {
    this.#window = window;
  }

  /** Whether there is a site around the page. */
  get isFramed(): boolean {
    const window: object = this.#window;
    return this.#window.parent !== window;
  }

  /** The reports contain nothing about the visitor, so every site that shows the page may read them. */
  send(report: FrameReport): void {
    this.#post({ corridor: 1, ...report });
  }

  /** Reports the size of the content, also as learning platforms expect it. */
  sendSize(width: number, height: number): void {
    this.send({ type: "size", width, height });
    this.#post({ subject: "lti.frameResize", height });
  }

  /** @param handle receives each request of the site; messages of others are ignored */
  listen(handle: (request: FrameRequest) => void): void {
    this.#window.addEventListener("message", ({ source, data }) => {
      if (!this.isFramed || source !== this.#window.parent) return;
      const request = readFrameRequest(data);
      if (request !== null) handle(request);
    });
  }

  #post(message: object): void {
    if (this.isFramed) this.#window.parent.postMessage(message, "*");
  }
}
