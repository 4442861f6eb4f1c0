import { relayToStudentSchema, type RelayToStudent, type StudentToRelay } from "@corridor/protocol";
import { ClassConnection, type ClassConnectionOptions } from "./class-connection.ts";

/** A message for the student. */
export type ClassMessage = Exclude<RelayToStudent, { type: "heartbeat" }>;

/** `key` is a student's key. */
export type StudentConnectionOptions = ClassConnectionOptions<ClassMessage>;

/** A student's connection to a class. It can run in a worker. */
export class StudentConnection extends ClassConnection<RelayToStudent, StudentToRelay> {
  /** Connects at once. */
  constructor(options: StudentConnectionOptions) {
    super(options, { role: "learn", schema: relayToStudentSchema });
  }
}
