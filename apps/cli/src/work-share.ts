/**
 * Distributes the units of a job over threads. The threads share the job and a counter, from which
 * each thread claims its next unit. All threads finish at about the same time.
 */

/** A job as numbered units, which any thread can do in any order. */
export interface Units<Result> {
  count: number;
  /** @param unit from 0 */
  run: (unit: number) => Result;
}

export interface WorkShare<Job> {
  job: Job;
  /** number of units claimed so far */
  claimed: Int32Array<SharedArrayBuffer>;
}

export interface FinishedUnit<Result> {
  unit: number;
  result: Result;
}

/** Runs units until none is left. @returns the results of this thread */
export function runShare<Result>(
  { count, run }: Units<Result>,
  claimed: WorkShare<unknown>["claimed"],
): FinishedUnit<Result>[] {
  const finished: FinishedUnit<Result>[] = [];
  for (;;) {
    const unit = Atomics.add(claimed, 0, 1);
    if (unit >= count) return finished;
    finished.push({ unit, result: run(unit) });
  }
}
