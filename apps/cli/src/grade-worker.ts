/**
 * Worker thread of `grade`: receives the shared job in a message, posts its graded pairs, and ends.
 */
import { parentPort } from "node:worker_threads";
import { gradeShare, type GradeShare } from "./grade-share.ts";

parentPort?.once("message", (share: GradeShare) => parentPort?.postMessage(gradeShare(share)));
