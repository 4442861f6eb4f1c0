/**
 * Pending announcements at a pace that listeners can follow. Chatter describes a state: only the
 * newest is pending, and never the state that was announced last. News describe events: they queue
 * up, and they make pending chatter obsolete. Pure: the caller passes the time.
 */

/** Minimum time between two announcements, in ms. */
export const SPEECH_INTERVAL_MS = 1000;
/** Maximum number of pending news. Beyond it, the oldest are dropped. */
const MOST_NEWS = 6;

/** A text to announce, in the student's language. */
export interface Utterance {
  text: string;
  kind: "chatter" | "news";
  /**
   * Chatter: the state it describes, so that the same state is not announced twice in a row; null
   * for a repeatable event. News: the subject, so that newer news replace older; null for
   * independent news.
   */
  about: string | null;
}

export class SpeechQueue {
  #news: Utterance[] = [];
  #chatter: Utterance | null = null;
  #saidState: string | null = null;
  #saidAt = Number.NEGATIVE_INFINITY;

  offer(utterance: Utterance): void {
    const { kind, about } = utterance;
    if (kind === "chatter") {
      this.#chatter = about !== null && about === this.#saidState ? null : utterance;
      return;
    }
    this.#chatter = null;
    const others = this.#news.filter((each) => about === null || each.about !== about);
    this.#news = [...others, utterance].slice(-MOST_NEWS);
  }

  /** Drops pending chatter, which is out of date. */
  dropChatter(): void {
    this.#chatter = null;
  }

  /** Permits the announcement of the last state again. */
  forgetState(): void {
    this.#saidState = null;
  }

  /** Time until the next announcement, in ms: 0 for at once, null if nothing is pending. */
  rest(now: number): number | null {
    if (this.#news.length === 0 && this.#chatter === null) return null;
    return Math.max(0, this.#saidAt + SPEECH_INTERVAL_MS - now);
  }

  /** Takes the next text to announce; null if nothing is pending or due. */
  take(now: number): string | null {
    if (this.rest(now) !== 0) return null;
    const news = this.#news.shift();
    const next = news ?? this.#chatter;
    if (next === null) return null;
    if (news === undefined) {
      this.#chatter = null;
      this.#saidState = next.about;
    }
    this.#saidAt = now;
    return next.text;
  }
}
