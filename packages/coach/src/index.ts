export { adviseProgram } from "./advise-program.ts";
export { applyFix } from "./apply-fix.ts";
export type {
  Advice,
  DelayedAboutFront,
  ImmediateIntoOpening,
  Fix,
  NeverDecides,
  NeverTrueHere,
  Side,
} from "./advice.ts";
export { LoopDetector, type LoopNotice } from "./loop-detector.ts";
export {
  bumpEvent,
  diagnoseFreePlay,
  diagnoseProgram,
  diagnoseStretch,
  FREE_PLAY_PAST,
  freePlayTask,
  type DiagnosisTask,
} from "./diagnosis/diagnose.ts";
export {
  causeLine,
  type BumpEvent,
  type Cause,
  type Decision,
  type Diagnosis,
  type FailureEvent,
  type WrongNumber,
} from "./diagnosis/diagnosis.ts";
export type { SolvedCheck } from "./diagnosis/run-trace.ts";
