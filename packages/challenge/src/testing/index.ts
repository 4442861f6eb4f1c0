export { lessonOfTasks, taskIn, type TaskChange } from "./lesson-of-tasks.ts";
