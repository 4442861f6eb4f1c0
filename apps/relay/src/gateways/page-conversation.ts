/** The page's part: it resumes with what it has done, then reports; it is told commands. */
import {
  closeReasons,
  decodeFrame,
  describeProblem,
  encodeFrame,
  pageToRelaySchema,
  resumeSchema,
  type FieldProblem,
  type SocketPort,
} from "@corridor/protocol";
import type { PageLink } from "../sessions/page-link.ts";
import type { Session } from "../sessions/session.ts";
import { closeWith, type Conversation } from "./conversation.ts";

export class PageConversation implements Conversation {
  readonly #session: Session;
  readonly #port: SocketPort;
  readonly #link: PageLink;
  #hasResumed = false;

  constructor(session: Session, port: SocketPort) {
    this.#session = session;
    this.#port = port;
    this.#link = {
      send: (message) => port.send(encodeFrame(message)),
      close: (reason) => closeWith(port, reason),
    };
  }

  async received(text: string): Promise<void> {
    if (!this.#hasResumed) {
      const resume = decodeFrame(resumeSchema, text);
      if (!resume.ok) return this.#refuse(resume.problems);
      this.#hasResumed = true;
      return this.#session.takePage(this.#link, resume.value);
    }
    const message = decodeFrame(pageToRelaySchema, text);
    if (!message.ok) return this.#refuse(message.problems);
    await this.#session.hearPage(this.#link, message.value);
  }

  heartbeat(): void {
    this.#link.send({ type: "heartbeat" });
  }

  closed(): void {
    this.#session.leavePage(this.#link);
  }

  #refuse(problems: FieldProblem[]): void {
    const [first] = problems;
    closeWith(this.#port, closeReasons.badFrame, first && describeProblem(first));
  }
}
