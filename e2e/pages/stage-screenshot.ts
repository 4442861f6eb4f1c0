/** Screenshots of the painted stage. Regions are in centimetres of the maze. */
import { expect, type Page } from "playwright/test";

interface Region {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** maximum share of pixels that may differ between equal screenshots: text smoothing can vary */
const MAX_DIFFERENCE = 0.01;

export class StageScreenshot {
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  /** A screenshot of the whole maze, once it no longer changes. */
  async capture(): Promise<Buffer> {
    let before = await this.#shoot();
    await expect
      .poll(async () => {
        const now = await this.#shoot();
        const isStill = now.equals(before);
        before = now;
        return isStill;
      })
      .toBe(true);
    return before;
  }

  async expectDifferent(picture: Buffer): Promise<void> {
    await expect
      .poll(async () => (await this.#compare(await this.#shoot(), picture)).share)
      .toBeGreaterThan(0);
  }

  async expectSame(picture: Buffer): Promise<void> {
    await expect
      .poll(async () => (await this.#compare(await this.#shoot(), picture)).share)
      .toBeLessThan(MAX_DIFFERENCE);
  }

  /** Number of pixels that differ between two regions of the same size. */
  async differingPixels(part: Region, other: Region): Promise<number> {
    return (await this.#compare(await this.#shoot(part), await this.#shoot(other))).pixels;
  }

  /**
   * Counts pixels that differ clearly, decoding the images in the browser. Different sizes differ
   * wholly.
   */
  async #compare(a: Buffer, b: Buffer): Promise<{ pixels: number; share: number }> {
    return this.#page.evaluate(
      async (pictures) => {
        const [one, two] = await Promise.all(
          pictures.map(async (base64) => {
            const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
            const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
            const canvas = document.createElement("canvas");
            [canvas.width, canvas.height] = [image.width, image.height];
            const context = canvas.getContext("2d");
            context?.drawImage(image, 0, 0);
            return context?.getImageData(0, 0, image.width, image.height).data ?? null;
          }),
        );
        if (!one || !two) throw new Error("the browser provided no canvas to compare on");
        const all = one.length / 4;
        if (one.length !== two.length) return { pixels: all, share: 1 };
        let pixels = 0;
        for (let at = 0; at < one.length; at += 4) {
          const isOther = [0, 1, 2].some(
            (part) => Math.abs((one[at + part] ?? 0) - (two[at + part] ?? 0)) > 24,
          );
          if (isOther) pixels++;
        }
        return { pixels, share: pixels / all };
      },
      [a, b].map((picture) => picture.toString("base64")),
    );
  }

  async #shoot(part?: Region): Promise<Buffer> {
    const grid = this.#page.getByRole("grid", { name: "Maze" });
    const box = await grid.boundingBox();
    if (box === null) throw new Error("the maze is not on the screen");
    const scale = box.width / (100 * Number(await grid.getAttribute("aria-colcount")));
    const region = part ?? { x: 0, y: 0, width: box.width / scale, height: box.height / scale };
    return this.#page.screenshot({
      clip: {
        x: Math.round(box.x + region.x * scale),
        y: Math.round(box.y + region.y * scale),
        width: Math.round(region.width * scale),
        height: Math.round(region.height * scale),
      },
    });
  }
}
