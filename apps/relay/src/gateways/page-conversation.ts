/** The page's part: it resumes with what it has done, then reports; it is told commands. */
import {
  closeReasons,
  decodeFrame,
  decodePageFrame,
  describeProblem,
  encodeFrame,
  resumeSchema,
  type FieldProblem,
  type SocketPort,
} from "@corridor/protocol";
import type { PageLink } from "../sessions/page-link.ts";
import type { Grant } from "../sessions/session-hub.ts";
import { closeWith, type Conversation } from "./conversation.ts";

export class PageConversation implements Conversation {
  readonly #grant: Grant;
  readonly #port: SocketPort;
  readonly #link: PageLink;
  #hasResumed = false;

  constructor(grant: Grant, port: SocketPort) {
    this.#grant = grant;
    this.#port = port;
    this.#link = {
      get isOpen() {
        return port.isOpen;
      },
      send: (message) => port.send(encodeFrame(message)),
      close: (reason) => closeWith(port, reason),
    };
  }

  received(text: string): Promise<void> | undefined {
    const { session, key } = this.#grant;
    session.check(key, "host");
    if (!this.#hasResumed) {
      const resume = decodeFrame(resumeSchema, text);
      if (!resume.ok) return this.#refuse(resume.problems);
      this.#hasResumed = true;
      return session.takePage(this.#link, resume.value);
    }
    const message = decodePageFrame(text);
    if (!message.ok) return this.#refuse(message.problems);
    return session.hearPage(this.#link, message.value);
  }

  heartbeat(): void {
    this.#link.send({ type: "heartbeat" });
  }

  closed(saidGoodbye: boolean): void {
    this.#grant.session.leavePage(this.#link, saidGoodbye);
  }

  #refuse([first]: FieldProblem[]): undefined {
    closeWith(this.#port, closeReasons.badFrame, first && describeProblem(first));
  }
}
