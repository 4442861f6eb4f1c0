/** Asks the worker for verdicts; it is started with the first question and kept. */
import type { CheckAnswer, CheckRequest } from "../../worker/check-request.ts";

/** As much of a Worker as is needed here. */
interface CheckPort {
  postMessage: (request: CheckRequest) => void;
  onmessage: ((event: MessageEvent<CheckAnswer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate: () => void;
}

interface Waiting {
  resolve: (answer: CheckAnswer) => void;
  reject: (error: Error) => void;
}

export class ChallengeChecker {
  readonly #start: () => CheckPort;
  #port: CheckPort | null = null;
  #waiting: Waiting[] = [];

  constructor(start: () => CheckPort) {
    this.#start = start;
  }

  /** @throws when the worker does not load or breaks; the next question starts a new one */
  async check(request: CheckRequest): Promise<CheckAnswer> {
    this.#port ??= this.#open();
    const port = this.#port;
    return new Promise((resolve, reject) => {
      this.#waiting.push({ resolve, reject });
      port.postMessage(request);
    });
  }

  #open(): CheckPort {
    const port = this.#start();
    port.onmessage = ({ data }) => this.#waiting.shift()?.resolve(data);
    port.onerror = ({ message }) => {
      port.terminate();
      this.#port = null;
      const waiting = this.#waiting;
      this.#waiting = [];
      for (const { reject } of waiting) reject(new Error(message));
    };
    return port;
  }
}

/** The checker of the page. */
export function startChecker(): ChallengeChecker {
  return new ChallengeChecker(
    () =>
      new Worker(new URL("../../worker/challenge-check.worker.ts", import.meta.url), {
        type: "module",
      }),
  );
}
