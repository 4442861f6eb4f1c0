/** Questions about bonus missions and solved mazes, which a worker answers by simulation. */
import type { BonusAnswer, BonusQuestion } from "../../simulator/protocol/bonus-request.ts";

/** Sends a question to the worker. @throws if the worker fails to load */
export type AskBonus = (question: BonusQuestion) => Promise<BonusAnswer>;

/** Starts one worker for each question. */
export const askWorker: AskBonus = async (question) =>
  new Promise((resolve, reject) => {
    const worker = new Worker(
      new URL("../../simulator/check-worker/bonus-check.worker.ts", import.meta.url),
      {
        type: "module",
      },
    );
    worker.onmessage = ({ data }: MessageEvent<BonusAnswer>) => {
      worker.terminate();
      resolve(data);
    };
    worker.onerror = ({ message }) => {
      worker.terminate();
      reject(new Error(message));
    };
    worker.postMessage(question);
  });
