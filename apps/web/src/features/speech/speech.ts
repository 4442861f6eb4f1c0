/**
 * The announcements of the page for screen readers. All of them use one live region, at most once a
 * second. Errors have an alert of their own, because they must not wait.
 */
import { createStore, type StoreApi } from "zustand/vanilla";
import { SpeechQueue, type Utterance } from "./speech-queue.ts";

/** A new object for each message, so that the same text can be announced again. */
export interface Said {
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
  readonly said: StoreApi<Said> = createStore<Said>()(() => ({ text: "" }));
  readonly #queue = new SpeechQueue();
  readonly #ports: SpeechPorts;
  /** last announced text of each state, by subject */
  readonly #told = new Map<string, string>();
  #isTimed = false;

  constructor(ports: SpeechPorts) {
    this.#ports = ports;
  }

  /**
   * Announces an event as soon as possible.
   * @param about newer news about the same subject replace pending ones
   */
  tell(text: string, about: string | null = null): void {
    this.say({ text, kind: "news", about });
  }

  /**
   * Announces a state when it has changed, however often it is called; null while there is nothing
   * to announce.
   */
  tellState(about: string, text: string | null): void {
    if (text === null) {
      // An obsolete text must not remain in the live region.
      if (this.#told.get(about) === this.said.getState().text) {
        this.said.setState({ text: "" });
      }
      this.#told.delete(about);
      return;
    }
    if (this.#told.get(about) === text) return;
    this.#told.set(about, text);
    this.tell(text, about);
  }

  say(utterance: Utterance): void {
    this.#queue.offer(utterance);
    this.#speak();
  }

  /** Queues an utterance for the next `breathe`, unless a newer one replaces it. */
  offer(utterance: Utterance): void {
    this.#queue.offer(utterance);
  }

  /** Announces what is pending, if it is due. Call it in frames that paint anyway. */
  breathe(): void {
    const text = this.#queue.take(this.#ports.now());
    if (text !== null) this.said.setState({ text });
  }

  /** Drops pending chatter, because the run is too fast or is no longer announced. */
  hush(): void {
    this.#queue.dropChatter();
  }

  /** Starts a new run. Its first line is announced even if it was the last one announced. */
  begin(): void {
    this.#queue.forgetState();
  }

  #speak(): void {
    this.breathe();
    const rest = this.#queue.rest(this.#ports.now());
    if (rest === null || this.#isTimed) return;
    this.#isTimed = true;
    this.#ports.later(() => {
      this.#isTimed = false;
      this.#speak();
    }, rest);
  }
}
