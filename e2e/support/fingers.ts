/** Fingers on the screen, as the browser tells a page of them: several at once, moved, lifted, taken away. */
import type { CDPSession, Locator, Page } from "playwright/test";

export interface Point {
  x: number;
  y: number;
}

/** Steps of a drag: a finger is never told of only where it began and ended. */
const STEPS = 8;

export class Fingers {
  readonly #browser: CDPSession;

  private constructor(browser: CDPSession) {
    this.#browser = browser;
  }

  static async of(page: Page): Promise<Fingers> {
    return new Fingers(await page.context().newCDPSession(page));
  }

  /** Lays one or more fingers down. */
  async down(...touchPoints: Point[]): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
  }

  async move(...touchPoints: Point[]): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints });
  }

  async lift(): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }

  /** The system takes the fingers: a call comes in, the screen is turned. */
  async takeAway(): Promise<void> {
    await this.#browser.send("Input.dispatchTouchEvent", { type: "touchCancel", touchPoints: [] });
  }

  /** One finger goes from place to place and lets go. */
  async drag(from: Point, ...places: Point[]): Promise<void> {
    await this.down(from);
    let at = from;
    for (const place of places) {
      for (let step = 1; step <= STEPS; step++) {
        const share = step / STEPS;
        await this.move({
          x: at.x + (place.x - at.x) * share,
          y: at.y + (place.y - at.y) * share,
        });
      }
      at = place;
    }
    await this.lift();
  }
}

/** The middle of what shows on the screen. */
export async function middleOf(target: Locator): Promise<Point> {
  const box = await target.boundingBox();
  if (box === null) throw new Error("nothing to lay a finger on");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
