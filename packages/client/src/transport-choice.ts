/**
 * Which way to the relay to try next: a WebSocket where the network lets it through, else plain HTTPS.
 * Only what happened to the lines before tells; a network says nothing of its filters.
 */
export type Door = "websocket" | "https";

/** How a line ended. */
export interface LineEnd {
  /** ms since the relay had said welcome on it; null when it never did */
  livedMs: number | null;
  /** the relay itself closed it, or the client: nothing on the way is to blame */
  isDeliberate: boolean;
}

/** A filter that cuts WebSockets does so soon, and again and again. */
const SHORT_LIFE_MS = 60_000;
const AT_ONCE_MS = 5_000;
const SHORT_LIVES = 2;
/** Where WebSockets have worked, a relay that restarts is likelier than a new filter. */
const PATIENT_TRIES = 3;
const FIRST_PROBE_MS = 15_000;
const LONGEST_PROBE_MS = 600_000;

export class DoorChoice {
  #door: Door = "websocket";
  #shortLives = 0;
  #hasWorked = false;
  #failedInARow = 0;
  #probeMs = FIRST_PROBE_MS;

  /** The way to try now. */
  get door(): Door {
    return this.#door;
  }

  /** Pause until a WebSocket is tried again, while the line by HTTPS works. */
  get probeMs(): number {
    return this.#probeMs;
  }

  /** The relay has said welcome on the line. */
  welcomed(): void {
    this.#failedInARow = 0;
  }

  /**
   * A line is lost.
   * @returns whether the other way is tried at once, without a pause
   */
  lost({ livedMs, isDeliberate }: LineEnd): boolean {
    if (this.#door === "https") {
      // Neither way works: the net or the relay is down, and a WebSocket may be what comes back first.
      if (livedMs === null) this.#door = "websocket";
      return false;
    }
    if (isDeliberate) return false;
    if (livedMs === null) {
      this.#failedInARow += 1;
      const isPatient = this.#hasWorked && this.#failedInARow < PATIENT_TRIES;
      return isPatient ? false : this.#fallBack();
    }
    if (livedMs >= AT_ONCE_MS) this.#hasWorked = true;
    else if (!this.#hasWorked) return this.#fallBack();
    this.#shortLives = livedMs < SHORT_LIFE_MS ? this.#shortLives + 1 : 0;
    return this.#shortLives >= SHORT_LIVES ? this.#fallBack() : false;
  }

  /** A WebSocket could be opened while HTTPS is in use: it is tried again, more rarely each time. */
  websocketOpened(): void {
    this.#door = "websocket";
    this.#notYet();
  }

  /** A WebSocket could not be opened. */
  websocketFailed(): void {
    this.#notYet();
  }

  #notYet(): void {
    this.#probeMs = Math.min(LONGEST_PROBE_MS, this.#probeMs * 2);
  }

  #fallBack(): boolean {
    this.#door = "https";
    this.#shortLives = 0;
    this.#failedInARow = 0;
    return true;
  }
}
