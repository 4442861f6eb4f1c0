/**
 * Worker thread of `grade`: receives the shared job in a message, posts the results of its units,
 * and ends.
 */
import { parentPort, workerData } from "node:worker_threads";
import type { JobKind } from "./all-cores.ts";
import { runShare, type Units, type WorkShare } from "./work-share.ts";

const kind: JobKind = workerData;
// Each kind of job loads its own modules only.
switch (kind) {
  case "runs":
    serve((await import("./run-units.ts")).unitsOfRuns);
    break;
  case "checks":
    serve((await import("./lesson/check-units.ts")).unitsOfChecks);
    break;
}

function serve<Job>(unitsOf: (job: Job) => Units<unknown>): void {
  parentPort?.once("message", ({ job, claimed }: WorkShare<Job>) =>
    parentPort?.postMessage(runShare(unitsOf(job), claimed)),
  );
}
