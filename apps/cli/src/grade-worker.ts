/**
 * Worker thread of `grade`: receives the shared job in a message, posts its graded pairs, and ends.
 * Each thread has to enable the compile cache for itself (see `main.ts`).
 */
import { enableCompileCache } from "node:module";
import { parentPort } from "node:worker_threads";
import type { GradeShare } from "./grade-share.ts";

enableCompileCache();
const { gradeShare } = await import("./grade-share.ts");
parentPort?.once("message", (share: GradeShare) => parentPort?.postMessage(gradeShare(share)));
