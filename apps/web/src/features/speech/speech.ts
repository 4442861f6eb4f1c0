/**
 * The one voice of the page: everything that is to be heard without being looked at comes here and
 * leaves by one live region, never more than once a second. What goes wrong has an alert of its own,
 * since it must not wait.
 */
import { createStore, type StoreApi } from "zustand/vanilla";
import { SpeechQueue, type Utterance } from "./speech-queue.ts";

/** Told anew with each message, so that the same words can be said again. */
export interface Said {
  text: string;
}

interface SpeechPorts {
  /** milliseconds since any fixed time */
  now: () => number;
  /** runs a function later, such as `setTimeout` */
  later: (run: () => void, milliseconds: number) => void;
}

export class Speech {
  /** what the live region says */
  readonly said: StoreApi<Said> = createStore<Said>()(() => ({ text: "" }));
  readonly #queue = new SpeechQueue();
  readonly #ports: SpeechPorts;
  /** what was told of things that stay as they are for a while */
  readonly #told = new Map<string, string>();
  #isTimed = false;

  constructor(ports: SpeechPorts) {
    this.#ports = ports;
  }

  /** Says that something has happened, as soon as it may. @param about newer news of the same take its place */
  tell(text: string, about: string | null = null): void {
    this.say({ text, kind: "news", about });
  }

  /**
   * Says how something stands when that has changed, however often it is asked to; null while there is
   * nothing to say of it.
   */
  tellState(about: string, text: string | null): void {
    if (text === null) {
      // What is no longer so is not left for readers to find.
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

  /** What is said with the next `breathe`, if nothing newer takes its place. */
  offer(utterance: Utterance): void {
    this.#queue.offer(utterance);
  }

  /** Says what waits, if it may be said by now: called where the page is painted anyway. */
  breathe(): void {
    const text = this.#queue.take(this.#ports.now());
    if (text !== null) this.said.setState({ text });
  }

  /** The run goes too fast to be told, or is not to be told any more: what waits of it is not said. */
  hush(): void {
    this.#queue.dropChatter();
  }

  /** The run begins anew: its first line is said even if it was the last one said. */
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
