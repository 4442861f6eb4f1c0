/** Checks open projects in its own worker. One message in, one answer out, in the same order. */
import { answerProject } from "./check-project.ts";
import type { ProjectQuestion } from "../protocol/project-request.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;

worker.onmessage = ({ data }: MessageEvent<ProjectQuestion>) => {
  worker.postMessage(answerProject(data));
};
