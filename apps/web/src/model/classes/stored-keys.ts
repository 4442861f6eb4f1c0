/** Entries of the tab's storage that only a student in a class has, besides the key. */
/** end of the pause */
export const PAUSE_KEY = "corridor.class.pause";
/** progress that the relay has not stored yet */
export const PROGRESS_KEY = "corridor.class.progress";
/** the lesson of the class that this tab has opened */
export const LESSON_KEY = "corridor.class.lesson";
/** hints that the teacher shows or the student opened, and which of them the student has closed */
export const HINTS_KEY = "corridor.class.hints";
/** what was reported last: the open task, and the programs that were tried */
export const REPORTED_KEY = "corridor.class.reported";

export const storedKeys = [PAUSE_KEY, PROGRESS_KEY, LESSON_KEY, HINTS_KEY, REPORTED_KEY] as const;
