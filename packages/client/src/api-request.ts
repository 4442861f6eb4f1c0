/** Single requests to the API of a robot, besides its connection. */
import { isTemporary } from "@corridor/protocol";
import type { HttpResponse, Platform } from "./platform.ts";
import { retryDelay } from "./retry-delay.ts";

/** Delay before a failed request is repeated. */
const RETRY_MS = 1_000;

export interface ApiOptions {
  platform: Platform;
  /** base URL of the robot's API */
  api: string;
  key: string;
  /** ms until a request is given up */
  timeoutMs: number;
}

export interface ApiRequest {
  /** null if there is no response in time, or after `cancel` */
  response: Promise<HttpResponse | null>;
  cancel(): void;
}

/**
 * Sends a request, and repeats it while the host does not respond or is busy.
 * @param path below the robot, such as `/maze`
 */
export function requestApi(
  { platform, api, key, timeoutMs }: ApiOptions,
  method: "GET" | "DELETE",
  path: string,
): ApiRequest {
  const { request, clock } = platform;
  const end = clock.now() + timeoutMs;
  let isCancelled = false;
  let cancelPending = (): void => undefined;
  const send = async (): Promise<HttpResponse | null> => {
    while (request !== undefined && clock.now() < end && !isCancelled) {
      const pending = request({ method, url: `${api}${path}`, key, body: null });
      cancelPending = () => pending.cancel();
      const cancelTimer = clock.after(end - clock.now(), cancelPending);
      const response = await pending.response.catch(() => null);
      cancelTimer();
      if (response !== null && !isTemporary(response)) return response;
      await new Promise<void>((resolve) => {
        const stopWaiting = clock.after(retryDelay(response, RETRY_MS), resolve);
        cancelPending = () => {
          stopWaiting();
          resolve();
        };
      });
    }
    return null;
  };
  const cancel = (): void => {
    isCancelled = true;
    cancelPending();
  };
  return { response: send(), cancel };
}
