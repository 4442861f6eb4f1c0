/**
 * The announcements of the page for screen readers. All of them use one live region, at most once a
 * second. Errors have an alert of their own, because they must not wait.
 */
import { createStore, type StoreApi } from "zustand/vanilla";
import { SpeechQueue, type Utterance } from "./speech-queue.ts";

/** A new object for each message, so that the same text can be announced again. */
export interface Announcement {
  text: string;
}

interface SpeechPorts {
  /** milliseconds since any fixed time */
  now: () => number;
  /** schedules a function, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export class Speech {
  /** text of the live region */
  readonly announcement: StoreApi<Announcement> = createStore<Announcement>()(() => ({ text: "" }));
  readonly #queue = new SpeechQueue();
  readonly #ports: SpeechPorts;
  /** last announced text of each state, by subject */
  readonly #announced = new Map<string, string>();
  #isTimed = false;

  constructor(ports: SpeechPorts) {
    this.#ports = ports;
  }

  /**
   * Announces an event as soon as possible.
   * @param about a newer event about the same subject replaces a pending one
   */
  announce(text: string, about: string | null = null): void {
    this.speak({ text, kind: "event", about });
  }

  /**
   * Announces a state when it has changed, however often it is called; null while there is nothing
   * to announce.
   */
  announceState(about: string, text: string | null): void {
    if (text === null) {
      this.#queue.drop(about);
      // An obsolete text must not remain in the live region.
      if (this.#announced.get(about) === this.announcement.getState().text) {
        this.announcement.setState({ text: "" });
      }
      this.#announced.delete(about);
      return;
    }
    if (this.#announced.get(about) === text) return;
    this.#announced.set(about, text);
    this.announce(text, about);
  }

  speak(utterance: Utterance): void {
    this.#queue.offer(utterance);
    this.#announceWhenDue();
  }

  /** Queues an utterance for the next `flush`, unless a newer one replaces it. */
  offer(utterance: Utterance): void {
    this.#queue.offer(utterance);
  }

  /** Announces what is pending, if it is due. Call it in frames that paint anyway. */
  flush(): void {
    const text = this.#queue.take(this.#ports.now());
    if (text !== null) this.announcement.setState({ text });
  }

  /** Drops pending events about a subject, which are out of date. */
  drop(about: string): void {
    this.#queue.drop(about);
  }

  /** Drops a pending state, because the run is too fast or is no longer announced. */
  dropState(): void {
    this.#queue.dropState();
  }

  /** Permits the announcement of the last state again, for example at the start of a run. */
  allowRepeat(): void {
    this.#queue.allowRepeat();
  }

  #announceWhenDue(): void {
    this.flush();
    const rest = this.#queue.rest(this.#ports.now());
    if (rest === null || this.#isTimed) return;
    this.#isTimed = true;
    this.#ports.later(() => {
      this.#isTimed = false;
      this.#announceWhenDue();
    }, rest);
  }
}
