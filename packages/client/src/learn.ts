/** Entry "@corridor/client/learn": for the page of a student in a class. */
export { LearnLink, type ClassMessage, type LearnLinkOptions } from "./student-connection.ts";
export type { ConnectionStatus } from "./connection.ts";
