export { findViolation, startingProgram } from "./allowed-program.ts";
export {
  AttemptJudge,
  termsOf,
  type AttemptTerms,
  type JudgedRobot,
  type Judgement,
} from "./attempt-judge.ts";
export {
  parseChallenge,
  readChallenge,
  type ChallengeDocument,
  type ChallengeWords,
} from "./challenge-document.ts";
export {
  conditionNameOf,
  conditionNames,
  editKinds,
  helpKinds,
  MAX_CHALLENGE_MAZES,
  MAX_CHALLENGE_TEXT_LENGTH,
  MAX_CHECK_BUMPS,
  MAX_CHECK_SECONDS,
  MAX_GOAL_DISTANCE,
  MAX_HINTS,
  MAX_LANGUAGE_LENGTH,
  MAX_LESSON_SECONDS,
  MAX_QUESTION_LENGTH,
  MAX_SHORT_LENGTH,
  MAX_SURVEY_QUESTIONS,
  MAX_TASK_LENGTH,
  MAX_TASKS,
  MAX_UNSEEN_COUNT,
  MAX_UNSEEN_SEED,
  MAX_UNSEEN_SIDE,
  MIN_UNSEEN_SIDE,
  toolNames,
  type ConditionName,
  type EditKind,
  type HelpKind,
  type ToolName,
} from "./challenge-limits.ts";
export {
  checkChallenge,
  checkMaze,
  isProgram,
  violationOf,
  type Attempt,
} from "./check-challenge.ts";
export {
  checkMazeOf,
  countMazes,
  mazeOf,
  taskVerdict,
  type TaskVerdict,
  type UnseenFailure,
} from "./check-task.ts";
export {
  checkUnitAt,
  countCheckUnits,
  runCheckUnit,
  type CheckJob,
  type CheckUnit,
} from "./check-units.ts";
export { GoalTracker } from "./goal-tracker.ts";
export {
  lessonOf,
  oldestDocumentOf,
  parseLesson,
  readLesson,
  readLessonDraft,
  taskOf,
  type LessonDocument,
  type LessonTask,
} from "./lesson-document.ts";
export { canonicalJson, lessonMark, MARK_LENGTH } from "./lesson-mark.ts";
export {
  checkedRow,
  lessonColumns,
  lessonFields,
  unreadableRow,
  violationRow,
  type Graded,
  type GradedRow,
  type LessonRow,
} from "./lesson-rows.ts";
export { rightsOf, type Rights } from "./rights.ts";
export type { Goal, Task } from "./task-schema.ts";
export { unseenName, unseenSchema, type UnseenMazes } from "./unseen-mazes.ts";
export type { Decision, Failure, FailureCode, MazeOutcome, Verdict } from "./verdict.ts";
