/**
 * How often the page is told of the run: its panels are read, not watched, so a calm rate will do, but
 * what decides is shown at once. Judged in the worker, so that nothing crosses in vain.
 */
import { FrameBuffer } from "./frame-buffer.ts";
import type { Frame } from "./worker-messages.ts";

/**
 * Milliseconds between two frames in which nothing was decided; four frames a second on average. Digits that
 * change more often are not read any better, and each change lays out, paints and puts together the page.
 */
const INTERVAL_MS = 1000 / 4;
/** Frames that may come sooner, one after the other, before the average has to be kept. */
const SPARE = 4;

export class FramePace {
  readonly #now: () => number;
  readonly #waiting = new FrameBuffer();
  #hasNews = false;
  #sent: Frame | null = null;
  #sentAt = Number.NEGATIVE_INFINITY;
  #spare = SPARE;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  add(frame: Frame): void {
    this.#waiting.add(frame);
    this.#hasNews = true;
  }

  /** The frame that the page is to be sent now; null while it can wait, or when nothing is new. */
  take(): Frame | null {
    const frame = this.#waiting.newest;
    if (!this.#hasNews || frame === null) return null;
    const now = this.#now();
    const intervals = (now - this.#sentAt) / INTERVAL_MS;
    const spare = Math.min(SPARE, this.#spare + intervals);
    // At high speed something is decided in every frame; nobody can read that, and nobody has to wait for it.
    const isEarly = intervals < 1;
    if (isEarly && !isDue(this.#sent, frame, spare)) return null;
    this.#spare = Math.max(0, spare - 1);
    this.#hasNews = false;
    this.#sent = frame;
    this.#sentAt = now;
    return this.#waiting.take();
  }
}

/** Whether a frame may come before its time. Who looks for a moment of the past sets the pace. */
function isDue(sent: Frame | null, frame: Frame, spare: number): boolean {
  if (sent === null || frame.view === "past") return true;
  return spare >= 1 && isDecided(sent, frame);
}

/**
 * Whether a frame must be shown at once: the deciding line, the state, the driver, a bump or the
 * goal changed, the run took its first tick, or the robot was put back. Numbers that merely move can wait.
 */
function isDecided(before: Frame, after: Frame): boolean {
  const shown = before.snapshot;
  const next = after.snapshot;
  return (
    before.view !== after.view ||
    shown.line !== next.line ||
    shown.state !== next.state ||
    shown.driver !== next.driver ||
    shown.motion !== next.motion ||
    shown.bumps !== next.bumps ||
    shown.goalReached !== next.goalReached ||
    shown.command !== next.command ||
    next.tick < shown.tick ||
    shown.tick === 0
  );
}
