/** Entry "@corridor/client/teach": for the dashboard of a teacher. */
export { TeachLink, type TeacherMessage, type TeachLinkOptions } from "./teacher-connection.ts";
export type { ConnectionStatus } from "./connection.ts";
