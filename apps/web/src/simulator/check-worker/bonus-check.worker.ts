/** Checks bonus missions in its own worker. One message in, one answer out, in the same order. */
import { answerBonus } from "./answer-bonus.ts";
import type { BonusQuestion } from "../protocol/bonus-request.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;

worker.onmessage = ({ data }: MessageEvent<BonusQuestion>) => {
  worker.postMessage(answerBonus(data));
};
