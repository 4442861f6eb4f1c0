import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

declare global {
  interface Window {
    audio: { contexts: number; tones: number };
  }
}

/**
 * Counts the page's use of Web Audio after its next load. @returns a function that reads the counts
 */
async function countAudio(page: Page): Promise<() => Promise<Window["audio"]>> {
  await page.addInitScript(() => {
    const audio = { contexts: 0, tones: 0 };
    window.audio = audio;
    window.AudioContext = class extends AudioContext {
      constructor() {
        super();
        audio.contexts++;
      }
      override createOscillator(): OscillatorNode {
        audio.tones++;
        return super.createOscillator();
      }
    };
  });
  return () => page.evaluate(() => window.audio);
}

test("is silent until sound is turned on, and stores the choice across a reload", async ({
  corridor,
  pageErrors,
}) => {
  const { page } = corridor;
  const audio = await countAudio(page);
  await corridor.reload();
  await corridor.run.click();
  await corridor.pause.click();
  expect(await audio()).toEqual({ contexts: 0, tones: 0 });

  const view = page.getByRole("button", { name: "View", exact: true });
  await view.click();
  const sound = page.getByRole("group", { name: "Sound" });
  await expect(sound.getByRole("checkbox", { name: "Play sounds" })).not.toBeChecked();
  await sound.getByRole("checkbox", { name: "Play sounds" }).check();
  await expect.poll(async () => (await audio()).contexts).toBe(1);
  await sound.getByRole("combobox", { name: "Beam that ticks" }).selectOption("right");
  await page.keyboard.press("Escape");
  const before = (await audio()).tones;
  await corridor.run.click();
  await expect.poll(async () => (await audio()).tones).toBeGreaterThan(before + 3);
  await corridor.pause.click();

  await corridor.reload();
  expect((await audio()).contexts).toBe(0);
  await view.click();
  await expect(sound.getByRole("checkbox", { name: "Play sounds" })).toBeChecked();
  await expect(sound.getByRole("combobox", { name: "Beam that ticks" })).toHaveValue("right");

  pageErrors.ignoreFailedRequests();
  await page.route(/\/sounds-[\w-]+\.js$/, (route) => route.abort());
  await corridor.reload();
  await expect(corridor.message(/^A part of Corridor did not load/)).toBeVisible();
});
