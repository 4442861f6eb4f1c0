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
