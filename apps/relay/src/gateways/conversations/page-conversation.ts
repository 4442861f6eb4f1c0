/**
 * Protocol of a page: it first reports what it has done, then sends events and receives commands.
 */
import {
  closeReasons,
  decodeFrame,
  describeProblem,
  encodeFrame,
  pageToRelaySchema,
  resumeSchema,
  type FieldProblem,
} from "@corridor/protocol";
import { readSnapshotMessage } from "../../bus/carried-snapshot.ts";
import type { PageConnection } from "../../robots/page/page-ownership.ts";
import type { Grant } from "../../robots/registry.ts";
import { closeWith, type Conversation, type ClientConnection } from "./conversation.ts";

type PageSocket = Pick<ClientConnection, "send" | "close" | "isOpen">;

export class PageConversation implements Conversation {
  readonly #grant: Grant;
  readonly #port: PageSocket;
  readonly #connection: PageConnection;
  #hasResumed = false;
  /** version of the rights at the last successful check */
  #checkedAt = -1;

  constructor(grant: Grant, port: PageSocket) {
    this.#grant = grant;
    this.#port = port;
    this.#connection = {
      get isOpen() {
        return port.isOpen;
      },
      send: (...messages) => port.send(...messages.map(encodeFrame)),
      close: (reason) => closeWith(port, reason),
    };
  }

  received(bytes: Buffer): Promise<void> | undefined {
    const { robot, caller } = this.#grant;
    // The result of a check holds until rights change or a second has passed.
    if (this.#checkedAt !== robot.rights.value) {
      robot.check(caller, "host");
      this.#checkedAt = robot.rights.value;
    }
    if (!this.#hasResumed) {
      const resume = decodeFrame(resumeSchema, bytes.toString());
      if (!resume.ok) return this.#refuse(resume.problems);
      this.#hasResumed = true;
      return robot.page.acquire(this.#connection, resume.value);
    }
    const report = readSnapshotMessage(bytes);
    if (report !== null) {
      robot.page.receiveSnapshot(this.#connection, report.epoch, report.snapshot);
      return undefined;
    }
    const message = decodeFrame(pageToRelaySchema, bytes.toString());
    if (!message.ok) return this.#refuse(message.problems);
    return robot.page.receive(this.#connection, message.value);
  }

  heartbeat(): void {
    this.#connection.send({ type: "heartbeat" });
  }

  closed(isClosedByClient: boolean): void {
    this.#grant.robot.page.leave(this.#connection, isClosedByClient);
  }

  #refuse([first]: FieldProblem[]): undefined {
    closeWith(this.#port, closeReasons.badFrame, first && describeProblem(first));
  }
}
