import {
  relayToTeacherSchema,
  sinceOf,
  type RelayToTeacher,
  type TeacherToRelay,
} from "@corridor/protocol";
import { ClassConnection, type ClassConnectionOptions } from "./class-connection.ts";

/** A batch has the tiles of up to 200 students, each of at most 1 KiB. */
const MAX_BATCH_LENGTH = 512 * 1_024;

/** A message for the dashboard. */
export type TeacherMessage = Exclude<RelayToTeacher, { type: "heartbeat" }>;

export interface TeacherConnectionOptions extends ClassConnectionOptions<TeacherMessage> {
  /** `since` of the class that the dashboard has read: it receives the events after it */
  since: string | null;
}

/**
 * A teacher's connection to a class. It can run in a worker. After a lost connection it receives the
 * events that it missed, or a `gap`: then read the class again.
 */
export class TeacherConnection extends ClassConnection<RelayToTeacher, TeacherToRelay> {
  /** Connects at once. `key` is a teacher's key. */
  constructor(options: TeacherConnectionOptions) {
    let { since } = options;
    let stream = "";
    const follow = (message: TeacherMessage): void => {
      if (message.type === "welcome") ({ stream } = message);
      if ("n" in message && message.n !== null) since = sinceOf(stream, message.n);
      if (message.type === "tiles") super.send({ type: "seen", seq: message.seq });
      options.onMessage(message);
    };
    super(
      { ...options, onMessage: follow },
      {
        role: "teach",
        schema: relayToTeacherSchema,
        maxLength: MAX_BATCH_LENGTH,
        since: () => since,
      },
    );
  }
}
