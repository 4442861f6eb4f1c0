/**
 * Touch input dispatched through the DevTools protocol: several fingers, moves, lifts and cancels.
 */
import type { CDPSession, Locator, Page } from "playwright/test";

export interface Point {
  x: number;
  y: number;
}

/** touchmove events per segment of a drag, as a real finger produces many */
const MOVES_PER_SEGMENT = 8;

export class TouchInput {
  readonly #browser: CDPSession;

  private constructor(browser: CDPSession) {
    this.#browser = browser;
  }

  static async of(page: Page): Promise<TouchInput> {
    return new TouchInput(await page.context().newCDPSession(page));
  }

  /** Puts one or more fingers down. */
  async down(...touchPoints: Point[]): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
  }

  async move(...touchPoints: Point[]): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints });
  }

  async lift(): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }

  /** Cancels the touch, as the system does for an incoming call or when the screen rotates. */
  async cancel(): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchCancel", touchPoints: [] });
  }

  /** Drags one finger through the points and lifts it. */
  async drag(from: Point, ...points: Point[]): Promise<void> {
    await this.down(from);
    let at = from;
    for (const point of points) {
      for (let step = 1; step <= MOVES_PER_SEGMENT; step++) {
        const share = step / MOVES_PER_SEGMENT;
        await this.move({
          x: at.x + (point.x - at.x) * share,
          y: at.y + (point.y - at.y) * share,
        });
      }
      at = point;
    }
    await this.lift();
  }
}

/** The centre of an element on the screen. */
export async function centreOf(target: Locator): Promise<Point> {
  const box = await target.boundingBox();
  if (box === null) throw new Error("the touch target is not on the screen");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
