/** One more core of `grade`: gets its share in a message, answers with what it graded, and ends. */
import { parentPort } from "node:worker_threads";
import { gradeShare, type GradeShare } from "./grade-share.ts";

parentPort?.once("message", (share: GradeShare) => parentPort?.postMessage(gradeShare(share)));
