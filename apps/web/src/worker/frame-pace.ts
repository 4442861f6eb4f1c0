/**
 * How often the page is told of the run: its panels are read, not watched, so a calm rate will do, but
 * what decides is shown at once. Judged in the worker, so that nothing crosses in vain.
 */
import { FrameBuffer } from "./frame-buffer.ts";
import type { Frame } from "./worker-messages.ts";

/** Milliseconds between two frames in which nothing was decided. */
const INTERVAL_MS = 50;

export class FramePace {
  readonly #now: () => number;
  readonly #waiting = new FrameBuffer();
  #hasNews = false;
  #sent: Frame | null = null;
  #sentAt = Number.NEGATIVE_INFINITY;

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
    const isCalm = this.#now() - this.#sentAt < INTERVAL_MS;
    if (isCalm && this.#sent !== null && !isDecided(this.#sent, frame)) return null;
    this.#hasNews = false;
    this.#sent = frame;
    this.#sentAt = this.#now();
    return this.#waiting.take();
  }
}

/**
 * Whether a frame must be shown at once: the deciding line, the state, the driver, a bump or the
 * goal changed, the robot was put back, or the reader looks for a moment of the past. Numbers that
 * merely move can wait.
 */
function isDecided(before: Frame, after: Frame): boolean {
  const shown = before.snapshot;
  const next = after.snapshot;
  return (
    before.view !== after.view ||
    after.view === "past" ||
    shown.line !== next.line ||
    shown.state !== next.state ||
    shown.driver !== next.driver ||
    shown.motion !== next.motion ||
    shown.bumps !== next.bumps ||
    shown.goalReached !== next.goalReached ||
    shown.command !== next.command ||
    next.tick < shown.tick
  );
}
