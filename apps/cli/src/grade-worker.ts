/**
 * One more core of `grade`: gets its share in a message, answers with what it graded, and ends.
 * The cache of compiled modules is each thread's own affair (see `main.ts`).
 */
import { enableCompileCache } from "node:module";
import { parentPort } from "node:worker_threads";
import type { GradeShare } from "./grade-share.ts";

enableCompileCache();
const { gradeShare } = await import("./grade-share.ts");
parentPort?.once("message", (share: GradeShare) => parentPort?.postMessage(gradeShare(share)));
