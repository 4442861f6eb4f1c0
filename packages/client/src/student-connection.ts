import { relayToStudentSchema, type RelayToStudent, type StudentToRelay } from "@corridor/protocol";
import { ClassLink, type ClassLinkOptions } from "./class-connection.ts";

/** A message for the student. */
export type ClassMessage = Exclude<RelayToStudent, { type: "heartbeat" }>;

/** `key` is a student's key. */
export type LearnLinkOptions = ClassLinkOptions<ClassMessage>;

/** A student's connection to a class. It can run in a worker. */
export class LearnLink extends ClassLink<RelayToStudent, StudentToRelay> {
  /** Connects at once. */
  constructor(options: LearnLinkOptions) {
    super(options, { role: "learn", schema: relayToStudentSchema });
  }
}
