/**
 * Checks programs against challenges in its own worker, so that neither the screen nor the robot
 * waits. One message in, one answer out, in the same order.
 */
import { checkProgram } from "./check-program.ts";
import type { CheckRequest } from "../protocol/check-request.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;

worker.onmessage = ({ data }: MessageEvent<CheckRequest>) => {
  worker.postMessage(checkProgram(data));
};
