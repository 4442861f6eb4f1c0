/** The documents alone, for readers that do not simulate: the relay, and the page's short links. */
export { challengeSchema, type ChallengeDocument } from "./challenge-document.ts";
export {
  challengeOrLessonSchema,
  lessonSchema,
  oldestDocumentOf,
  readLesson,
  type LessonDocument,
} from "./lesson-document.ts";
