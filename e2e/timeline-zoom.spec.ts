/** Zooming and scrolling the timeline. */
import { expect, test } from "./fixtures.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

test("zooms by buttons, keys and the wheel, and scrolls", async ({ corridor, page }) => {
  const { timeline } = corridor;
  await corridor.speed.selectOption("4×");
  await corridor.run.click();
  await expect(timeline.mark("turn").nth(2)).toBeVisible();
  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
  await expect(timeline.axis.first()).toHaveText("0 s");
  await expect(timeline.visiblePart).toBeHidden();

  await timeline.zoomIn.click();
  await timeline.zoomIn.click();
  await timeline.zoomIn.click();
  await expect(timeline.axis.first()).toHaveText(/^\d+:\d\d$/);
  await expect(timeline.visiblePart).toBeVisible();
  const names = await timeline.axis.allTextContents();
  expect(new Set(names).size).toBe(names.length);

  await timeline.visiblePart.evaluate((box) => box.scrollTo(0, 0));
  await expect(timeline.axis.first()).toHaveText("0:00");
  await timeline.slider.press("Home");
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await timeline.slider.press("End");
  await expect(timeline.axis.first()).not.toHaveText("0:00");

  await timeline.slider.press("0");
  await expect(timeline.axis.first()).toHaveText("0 s");
  await timeline.slider.press("+");
  await expect(timeline.axis.first()).toHaveText(/^\d+:\d\d$/);
  await timeline.slider.press("-");
  await expect(timeline.axis.first()).toHaveText("0 s");

  const { x, y } = await timeline.pointAt(0.3);
  await page.mouse.move(x, y);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -100);
  await page.keyboard.up("Control");
  await expect(timeline.visiblePart).toBeVisible();
  await timeline.wholeRun.click();
  await expect(timeline.visiblePart).toBeHidden();
});

test("zooms with two fingers on a phone, and returns to the whole run", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  const { timeline } = phone;
  await phone.speed.selectOption("4×");
  await phone.run.click();
  await expect(timeline.mark("turn").nth(2)).toBeVisible();
  await phone.pause.click();
  const before = await timeline.mark("turn").first().boundingBox();
  const last = await timeline.mark("turn").nth(1).boundingBox();
  const distance = (last?.x ?? 0) - (before?.x ?? 0);
  // The gestures load with the buttons, which a phone hides.
  await timeline.zoomButtons.waitFor({ state: "attached" });
  const { x, y } = await timeline.pointAt(0.1);
  await timeline.slider.evaluate(
    (slider, at) => {
      const bar = slider.parentElement;
      if (bar === null) return;
      const touch = (identifier: number, clientX: number) =>
        new Touch({ identifier, target: bar, clientX, clientY: at.y });
      const send = (type: string, half: number | null) =>
        bar.dispatchEvent(
          new TouchEvent(type, {
            touches: half === null ? [] : [touch(0, at.x - half), touch(1, at.x + half)],
            bubbles: true,
            cancelable: true,
          }),
        );
      send("touchstart", 10);
      send("touchmove", 20);
      send("touchend", null);
    },
    { x, y },
  );
  await expect
    .poll(async () => {
      const first = await timeline.mark("turn").first().boundingBox();
      const second = await timeline.mark("turn").nth(1).boundingBox();
      return ((second?.x ?? 0) - (first?.x ?? 0)) / distance;
    })
    .toBeGreaterThan(1.5);
});
