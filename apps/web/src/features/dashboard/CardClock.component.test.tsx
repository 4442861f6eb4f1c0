import { expect, it, onTestFinished, vi } from "vitest";
import { render } from "vitest-browser-react";
import { CardClock } from "./CardClock.tsx";
import { classTimeText } from "./class-time-text.ts";

const SECOND = 1_000;
const MINUTE = 60 * SECOND;
const HOUR = 60 * MINUTE;
/** Within a second, whose borders an animation rounds. */
const LATER = 300;
/** A full second of the device. */
const START = 1_700_000_000_000;

async function showClock(startedAt: number): Promise<void> {
  const time = { minutes: 0, startedAt, seconds: 0 };
  await render(
    <div className="clock" style={{ lineHeight: "20px" }}>
      <CardClock time={time} />
    </div>,
  );
}

/** The text that is visible: of each strip, the line in its window. */
function visibleText(): string {
  const parts = document.querySelector(".clock > span")?.childNodes ?? [];
  return [...parts]
    .map((part) => {
      const strip = part.firstChild;
      if (!(part instanceof Element) || !(strip instanceof Element)) return part.textContent ?? "";
      const lines = (strip.textContent ?? "").split("\n");
      const { top, height } = strip.getBoundingClientRect();
      const line = (part.getBoundingClientRect().top - top) / (height / lines.length);
      return lines[Math.round(line)] ?? `line ${line}`;
    })
    .join("");
}

it.each([0, 7 * SECOND, MINUTE, 10 * MINUTE - SECOND, 10 * MINUTE, HOUR - SECOND, HOUR])(
  "shows the time after %i ms to the second",
  async (age) => {
    vi.useFakeTimers({ now: START + age + LATER, toFake: ["Date"] });
    onTestFinished(() => void vi.useRealTimers());
    await showClock(START);
    expect(visibleText()).toBe(classTimeText(age));
  },
);

it.each([MINUTE, 10 * MINUTE, HOUR])(
  "goes on when minutes, digits or hours begin, after %i ms",
  async (age) => {
    await showClock(Date.now() - age + SECOND);
    await expect.poll(visibleText).toBe(classTimeText(age));
  },
);

it("is set to the clock of the device after the device has slept", async () => {
  // No other test waits for a time of this one.
  const start = START + 24 * HOUR;
  vi.useFakeTimers({ now: start, toFake: ["Date", "setTimeout", "clearTimeout"] });
  onTestFinished(() => void vi.useRealTimers());
  await showClock(start);
  expect(visibleText()).toBe("0:00");
  // The animations stood still, and the timer fires late.
  vi.setSystemTime(start + 5 * MINUTE + 20 * SECOND + LATER);
  vi.advanceTimersByTime(MINUTE);
  expect(visibleText()).toBe("6:20");
});
