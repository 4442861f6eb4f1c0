/** A worker of a pool: runs units of jobs, and handles messages in between. */
import type { FromPoolWorker, ToPoolWorker } from "../protocol/pool-messages.ts";
import { runUnit } from "./run-unit.ts";
import { UnitQueue } from "./unit-queue.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;
const queue = new UnitQueue({
  run: runUnit,
  post: (message: FromPoolWorker) => worker.postMessage(message),
  now: () => performance.now(),
});

const { port1: turn, port2: turns } = new MessageChannel();
/** whether a turn is on its way */
let isTurning = false;

worker.onmessage = ({ data }: MessageEvent<ToPoolWorker>) => {
  queue.receive(data);
  nextTurn();
};

turns.onmessage = () => {
  isTurning = false;
  queue.runSlice();
  nextTurn();
};

function nextTurn(): void {
  if (isTurning || queue.size === 0) return;
  isTurning = true;
  turn.postMessage(null);
}
