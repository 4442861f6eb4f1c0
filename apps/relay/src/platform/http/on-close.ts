/** Ends what a request has started when its connection closes. */
import type { Response } from "express";

/**
 * Calls a listener when the response ends or the client disconnects. If it has disconnected
 * already, for example during authorisation, calls it immediately.
 */
export function onClose(response: Response, listener: () => void): void {
  if (response.closed) listener();
  else response.once("close", listener);
}

/** A signal that aborts when the response ends or the client disconnects. */
export function closeSignal(response: Response): AbortSignal {
  const controller = new AbortController();
  onClose(response, () => controller.abort());
  return controller.signal;
}
