/** Asks the class for another name, before the student's page connects. Loaded on first use. */
import {
  StudentConnection,
  type ClassMessage,
  type StudentConnectionOptions,
} from "@corridor/client/learn";
import type { JoinedClass, StudentName } from "@corridor/protocol";
import type { ClassEnding } from "../../simulator/protocol/class-messages.ts";
import { endingOf } from "../../simulator/protocol/class-ending.ts";

const NO_OTHER_NAME = "/problems/no-other-name";

export type RenameAnswer =
  /** the same name if the student has used both changes before */
  | { ok: true; name: StudentName; renamesLeft: number }
  /** refused: all names are in use */
  | { ok: false; reason: "refused" | "offline" | ClassEnding };

/**
 * @param origin of the page and its relay
 * @param platform default: that of the browser
 */
export function requestName(
  { class: id, key }: JoinedClass,
  origin: string,
  platform?: NonNullable<StudentConnectionOptions["platform"]>,
): Promise<RenameAnswer> {
  return new Promise((resolve) => {
    const end = (answer: RenameAnswer): void => {
      connection.close();
      resolve(answer);
    };
    const receive = (message: ClassMessage): void => {
      const isUsedUp = message.type === "welcome" && message.renamesLeft === 0;
      if (isUsedUp || message.type === "name") {
        const { name, renamesLeft } = message;
        end({ ok: true, name, renamesLeft });
      } else if (message.type === "problem") {
        const isRefused = message.problem.type === NO_OTHER_NAME;
        end({ ok: false, reason: isRefused ? "refused" : "offline" });
      }
    };
    const connection: StudentConnection = new StudentConnection({
      origin,
      id,
      key,
      onMessage: receive,
      onStatus: (status) => {
        if (status.kind === "connected") connection.send({ type: "name" });
        if (status.kind === "lost") end({ ok: false, reason: "offline" });
        if (status.kind === "over") end({ ok: false, reason: endingOf(status.reason.code) });
      },
      ...(platform === undefined ? {} : { platform }),
    });
  });
}
