/** The part of the worker for a student in a class. Loads when the page of a student connects. */
import type { FromWorker } from "../protocol/worker-messages.ts";
import { ClassHost } from "./class-host.ts";
import type { RunLoop } from "./run-loop.ts";

/**
 * @param run the live run
 * @param guarded calls a function and handles its errors
 */
export function openClassPart(
  run: () => RunLoop,
  origin: string,
  post: (message: FromWorker) => void,
  guarded: (work: () => void) => void,
): ClassHost {
  return new ClassHost({
    origin,
    now: () => Date.now(),
    run,
    onSession: (session) => post({ type: "class", session }),
    onHint: (hint) => post({ type: "class-hint", hint }),
    after: (ms, call) => {
      const timer = setTimeout(() => guarded(call), ms);
      return () => clearTimeout(timer);
    },
  });
}
