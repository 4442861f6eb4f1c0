/**
 * Checks programs against challenges beside the page, so that neither the screen nor the robot waits.
 * One message in, one verdict out, in the same order.
 */
import { checkChallenge, type Verdict } from "@corridor/challenge";
import type { CheckRequest } from "./check-request.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;

worker.onmessage = ({ data }: MessageEvent<CheckRequest>) => {
  const verdict: Verdict = checkChallenge(data.challenge, data.program);
  worker.postMessage(verdict);
};
