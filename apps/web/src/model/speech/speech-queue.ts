/**
 * Pending announcements at a pace that listeners can follow. Of states, only the newest is pending,
 * and never the state that was announced last. Events queue up, and they make a pending state
 * obsolete. Pure: the caller passes the time.
 */

/** Minimum time between two announcements, in ms. */
export const SPEECH_INTERVAL_MS = 1000;
/** Maximum number of pending events. Beyond it, the oldest are dropped. */
const MAX_EVENTS = 6;

/** A text to announce, in the student's language. */
export interface Utterance {
  text: string;
  kind: "state" | "event";
  /**
   * State: its name, so that the same state is not announced twice in a row; null if it may
   * repeat. Event: its subject, so that a newer event replaces an older one; null for an
   * independent event.
   */
  about: string | null;
}

export class SpeechQueue {
  #events: Utterance[] = [];
  #state: Utterance | null = null;
  #announcedState: string | null = null;
  #announcedAt = Number.NEGATIVE_INFINITY;

  offer(utterance: Utterance): void {
    const { kind, about } = utterance;
    if (kind === "state") {
      this.#state = about !== null && about === this.#announcedState ? null : utterance;
      return;
    }
    this.#state = null;
    const others = this.#events.filter((each) => about === null || each.about !== about);
    this.#events = [...others, utterance].slice(-MAX_EVENTS);
  }

  /** Drops a pending state, which is out of date. */
  dropState(): void {
    this.#state = null;
  }

  /** Drops pending events about a subject, which are out of date. */
  drop(about: string): void {
    this.#events = this.#events.filter((each) => each.about !== about);
  }

  /** Permits the announcement of the last state again. */
  allowRepeat(): void {
    this.#announcedState = null;
  }

  /** Time until the next announcement, in ms: 0 for at once, null if nothing is pending. */
  rest(now: number): number | null {
    if (this.#events.length === 0 && this.#state === null) return null;
    return Math.max(0, this.#announcedAt + SPEECH_INTERVAL_MS - now);
  }

  /** Takes the next text to announce; null if nothing is pending or due. */
  take(now: number): string | null {
    if (this.rest(now) !== 0) return null;
    const event = this.#events.shift();
    const next = event ?? this.#state;
    if (next === null) return null;
    if (event === undefined) {
      this.#state = null;
      this.#announcedState = next.about;
    }
    this.#announcedAt = now;
    return next.text;
  }
}
