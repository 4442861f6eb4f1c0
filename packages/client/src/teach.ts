/** Entry "@corridor/client/teach": for the dashboard of a teacher. */
export {
  TeacherConnection,
  type TeacherMessage,
  type TeacherConnectionOptions,
} from "./teacher-connection.ts";
export type { ConnectionStatus } from "./connection.ts";
