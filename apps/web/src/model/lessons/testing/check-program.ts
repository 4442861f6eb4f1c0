/** Checks a program as the page does, with a worker in this thread. */
import { FakePoolWorker } from "../../../simulator/testing/fake-pool-worker.ts";
import { WorkerPool } from "../../../simulator/worker-pool.ts";
import type { CheckAnswer, CheckRequest } from "../../check/checked-task.ts";
import { ProgramCheck, type CheckEnd } from "../program-check.ts";

export function checkProgram(request: CheckRequest): CheckAnswer {
  const worker = new FakePoolWorker();
  const check = new ProgramCheck(new WorkerPool(() => worker, 1), () => undefined);
  const ends: CheckEnd[] = [];
  check.start(request, (end) => ends.push(end));
  while (worker.answer());
  const [end] = ends;
  if (end === undefined || !end.ok) throw new Error("the check did not end");
  return end.answer;
}
