/**
 * Requests verdicts from a worker. The first request starts the worker, and later requests reuse
 * it.
 */
import type { CheckAnswer, CheckRequest } from "../../simulator/protocol/check-request.ts";

/** The part of Worker that the checker uses. */
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

  /** @throws when the worker fails to load or crashes. The next request starts a new worker. */
  async check(request: CheckRequest): Promise<CheckAnswer> {
    this.#port ??= this.#open();
    const port = this.#port;
    return new Promise((resolve, reject) => {
      this.#waiting.push({ resolve, reject });
      port.postMessage(request);
    });
  }

  /** Terminates the worker. Pending requests are not answered. */
  close(): void {
    this.#port?.terminate();
    this.#port = null;
    this.#waiting = [];
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

/** Creates the page's checker. */
export function startChecker(): ChallengeChecker {
  return new ChallengeChecker(
    () =>
      new Worker(
        new URL("../../simulator/check-worker/challenge-check.worker.ts", import.meta.url),
        {
          type: "module",
        },
      ),
  );
}
