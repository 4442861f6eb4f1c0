/**
 * Throttles the frames for the page's panels. Readers need a low rate, but important changes are
 * displayed at once. It runs in the worker, so that nothing is sent in vain.
 */
import { FrameBuffer } from "../../stage/frame-buffer.ts";
import type { Frame } from "../../stage/drawing/frame.ts";

/**
 * Milliseconds between two frames without important changes; four frames a second on average.
 * Digits that change faster are not more readable, and each change costs layout, paint and
 * compositing.
 */
const INTERVAL_MS = 1000 / 4;
/** Frames that may be sent early before the average applies. */
const SPARE = 4;

export class FrameThrottle {
  readonly #now: () => number;
  readonly #waiting = new FrameBuffer();
  #hasChanged = false;
  #sent: Frame | null = null;
  #sentAt = Number.NEGATIVE_INFINITY;
  #spare = SPARE;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  add(frame: Frame): void {
    this.#waiting.add(frame);
    this.#hasChanged = true;
  }

  /** The frame to send now; null if it can wait, or if nothing changed. */
  take(): Frame | null {
    const frame = this.#waiting.newest;
    if (!this.#hasChanged || frame === null) return null;
    const now = this.#now();
    const intervals = (now - this.#sentAt) / INTERVAL_MS;
    const spare = Math.min(SPARE, this.#spare + intervals);
    // At high speed every frame changes something important; nobody can read that, and nobody has
    // to wait for it.
    const isEarly = intervals < 1;
    if (isEarly && !isDue(this.#sent, frame, spare)) return null;
    this.#spare = Math.max(0, spare - 1);
    this.#hasChanged = false;
    this.#sent = frame;
    this.#sentAt = now;
    return this.#waiting.take();
  }
}

/**
 * Whether a frame may be sent early. Seeking is not throttled. Neither is the goal, whose time the
 * page states: the timeline, which comes with the frame, counts how long a script made its robot wait.
 */
function isDue(sent: Frame | null, frame: Frame, spare: number): boolean {
  if (sent === null || frame.view === "past") return true;
  if (frame.snapshot.goalReached && !sent.snapshot.goalReached) return true;
  return spare >= 1 && isDecided(sent, frame);
}

/**
 * Whether a frame must be sent at once: the deciding line, state, driver, bumps or goal changed,
 * the run took its first tick, or the robot was reset. Changed numbers can wait.
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
