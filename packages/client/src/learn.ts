/** Entry "@corridor/client/learn": for the page of a student in a class. */
export {
  StudentConnection,
  type ClassMessage,
  type StudentConnectionOptions,
} from "./student-connection.ts";
export type { ConnectionStatus } from "./connection.ts";
