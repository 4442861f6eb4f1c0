export { adviseProgram } from "./advise-program.ts";
export { applyMend } from "./apply-mend.ts";
export type {
  Advice,
  DelayedAboutFront,
  ImmediateIntoOpening,
  Mend,
  NeverDecides,
  NeverTrueHere,
  Side,
} from "./advice.ts";
export type { Blame } from "./blame.ts";
export { mendOfEarlierTurn, mendsForBump, type BumpScene } from "./bump-mends.ts";
export { storyOfBump, type BumpFacts, type BumpStory } from "./bump-story.ts";
export { LoopWatch, type LoopNotice } from "./loop-watch.ts";
export { findBlame, type FailedAttempt } from "./find-blame.ts";
