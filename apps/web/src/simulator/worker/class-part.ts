/** The part of the worker for a student in a class. Loads when the page of a student connects. */
import type { FromWorker } from "../protocol/worker-messages.ts";
import { ClassHost } from "./class-host.ts";

/** @param guarded calls a function and handles its errors */
export function openClassPart(
  origin: string,
  post: (message: FromWorker) => void,
  guarded: (work: () => void) => void,
): ClassHost {
  return new ClassHost({
    origin,
    now: () => Date.now(),
    onSession: (session) => post({ type: "class", session }),
    after: (ms, call) => {
      const timer = setTimeout(() => guarded(call), ms);
      return () => clearTimeout(timer);
    },
  });
}
