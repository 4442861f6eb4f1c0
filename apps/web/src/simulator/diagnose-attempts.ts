/** Diagnoses failed attempts on the workers of a pool. */
import type { Diagnosis } from "@corridor/coach";
import type { AttemptToDiagnose } from "./protocol/pool-messages.ts";
import type { WorkerPool } from "./worker-pool.ts";

interface DiagnosisListener {
  /** @param at index in the attempts @param diagnosis null if the attempt passes */
  onDiagnosis: (diagnosis: Diagnosis | null, at: number) => void;
  /** all attempts are diagnosed, or another job has taken the place of this one */
  onEnd: () => void;
}

/** Runs in place of the pool's current job. */
export function diagnoseAttempts(
  pool: Pick<WorkerPool, "run">,
  attempts: readonly AttemptToDiagnose[],
  { onDiagnosis, onEnd }: DiagnosisListener,
): void {
  let left = attempts.length;
  if (left === 0) {
    onEnd();
    return;
  }
  pool.run({ kind: "diagnose", attempts }, left, {
    onResult: (result, at) => {
      if (result.kind === "diagnose") onDiagnosis(result.diagnosis, at);
      if (--left === 0) onEnd();
    },
    onEnd: () => onEnd(),
  });
}
