/**
 * What waits to be said, at a pace that can be listened to. Chatter tells how things stand: only the
 * newest waits, and none that says again what was said last. News tell what has happened: none is lost,
 * and chatter that waited for its turn is out of date. Pure: the time is passed in.
 */

/** At least so long between two messages, in ms. */
export const SPEECH_INTERVAL_MS = 1000;
/** News that wait at most; of more, the oldest are left out. */
const MOST_NEWS = 6;

/** Something to say, in the reader's language. */
export interface Utterance {
  text: string;
  kind: "chatter" | "news";
  /**
   * chatter: what state it tells, so that the same one is not said twice in a row; null for what
   * happens anew each time. news: what it is about, so that newer takes the place of older; null for
   * news of its own.
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

  /** What waits of the chatter is out of date. */
  dropChatter(): void {
    this.#chatter = null;
  }

  /** The state that was said last may be said again. */
  forgetState(): void {
    this.#saidState = null;
  }

  /** How long until the next one may be said, in ms; 0 at once, null when nothing waits. */
  rest(now: number): number | null {
    if (this.#news.length === 0 && this.#chatter === null) return null;
    return Math.max(0, this.#saidAt + SPEECH_INTERVAL_MS - now);
  }

  /** What is to be said now, and is then said; null when nothing is, or not yet. */
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
