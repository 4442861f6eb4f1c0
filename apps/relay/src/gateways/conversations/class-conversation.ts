/** Protocol of a student, a dashboard or a big screen of a class, on every transport. */
import {
  closeReasons,
  decodeFrame,
  decodeTeacherFrame,
  encodeFrame,
  MAX_TILE_LENGTH,
  screenToRelaySchema,
  studentToRelaySchema,
  type ClassHello,
  type CloseReason,
  type ReadResult,
  type RelayToScreen,
  type RelayToStudent,
  type RelayToTeacher,
  type StudentToRelay,
} from "@corridor/protocol";
import type { Member } from "../../classes/access.ts";
import type { LiveClass } from "../../classes/live-class.ts";
import type { LeaveReason, MemberConnection } from "../../classes/member-connection.ts";
import type { ClassGrant } from "../../classes/registry.ts";
import { helpStep, programStep, progressStep, renameStep } from "../../classes/student-steps.ts";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import { asRefusal, badRequest } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { MessageRates } from "../../platform/limits/message-rates.ts";
import type { Clock } from "../../platform/time/clock.ts";
import { withBoundedQueue } from "./bounded-queue.ts";
import { closeWith, type Conversation, type ClientConnection } from "./conversation.ts";
import type { GatewayMetrics } from "./start-conversation.ts";

type Connection = Pick<ClientConnection, "send" | "close" | "isOpen">;
type RelayToMember = RelayToStudent | RelayToTeacher | RelayToScreen;

const closings: Record<LeaveReason, { reason: CloseReason; detail: string }> = {
  removed: {
    reason: closeReasons.forbidden,
    detail: "The teacher removed this student. Join the class again with its code.",
  },
  replaced: {
    reason: closeReasons.replaced,
    detail: "Another tab or device is this student now. Continue there.",
  },
  over: { reason: closeReasons.over, detail: "The class has ended." },
};

/** Errors that the client receives as a message. All others close the connection. */
const problems: ReadonlySet<ProblemKind> = new Set<ProblemKind>([
  "bad-request",
  "too-fast",
  "no-student",
  "no-other-name",
  "storage-full",
]);

export interface ClassConversationOptions {
  hello: ClassHello;
  /** what its key permits */
  grant: ClassGrant;
  connection: Connection;
  metrics: GatewayMetrics;
  clock: Clock;
}

/** What a member does with the texts that it receives. */
interface Handler {
  /** @throws Refusal */
  received(text: string): Promise<void> | undefined;
  leave(): void;
}

/**
 * Starts a conversation as a student, a dashboard or a big screen.
 * @throws Refusal too-many-readers, or not-authorised if the key has become invalid
 */
export function startClassConversation(options: ClassConversationOptions): Conversation {
  const { connection, grant, metrics } = options;
  const handler = handlerOf(options);
  const conversation = new ClassConversation(handler, grant.found, connection, metrics);
  return withBoundedQueue(conversation, connection);
}

function handlerOf(options: ClassConversationOptions): Handler {
  const { member } = options.grant;
  if (member.kind === "learn") return studentHandler(options, member);
  return member.kind === "teach" ? teacherHandler(options) : screenHandler(options);
}

class ClassConversation implements Conversation {
  readonly #handler: Handler;
  readonly #class: LiveClass;
  readonly #connection: Connection;
  readonly #metrics: GatewayMetrics;
  #badFrames = 0;
  #tooFastInARow = 0;

  constructor(
    handler: Handler,
    joined: LiveClass,
    connection: Connection,
    metrics: GatewayMetrics,
  ) {
    this.#handler = handler;
    this.#class = joined;
    this.#connection = connection;
    this.#metrics = metrics;
  }

  received(bytes: Buffer): Promise<void> | undefined {
    this.#class.used();
    try {
      const pending = this.#handler.received(bytes.toString());
      this.#tooFastInARow = 0;
      return pending?.catch((error: unknown) => this.#refuse(error));
    } catch (error) {
      this.#refuse(error);
      return undefined;
    }
  }

  heartbeat(): void {
    this.#connection.send(encodeFrame({ type: "heartbeat" }));
  }

  closed(): void {
    this.#handler.leave();
  }

  #refuse(error: unknown): void {
    const { kind, problem } = asRefusal(error);
    if (!problems.has(kind)) throw error;
    this.#metrics.refused(kind);
    this.#connection.send(encodeFrame({ type: "problem", problem }));
    if (kind === "bad-request") this.#badFrames += 1;
    if (kind === "too-fast") this.#tooFastInARow += 1;
    const { badFrames, tooFastInARow } = limits;
    if (this.#badFrames < badFrames && this.#tooFastInARow < tooFastInARow) return;
    closeWith(this.#connection, closeReasons.badFrame);
  }
}

function typedConnection<M extends RelayToMember>(connection: Connection): MemberConnection<M> {
  return {
    send: (message) => connection.send(encodeFrame(message)),
    close: (why) => closeWith(connection, closings[why].reason, closings[why].detail),
  };
}

function studentHandler(
  { grant, connection }: ClassConversationOptions,
  { student, key }: Extract<Member, { kind: "learn" }>,
): Handler {
  const { found } = grant;
  const caller = { student, key };
  const toStudent = typedConnection<RelayToStudent>(connection);
  const member = found.connections.joinStudent(caller, toStudent);
  const store = async (message: Exclude<StudentToRelay, { type: "tile" }>): Promise<void> => {
    switch (message.type) {
      case "progress":
        await found.run(progressStep(caller, message.seq, message.event));
        return toStudent.send({ type: "stored", what: "progress", seq: message.seq });
      case "program":
        await found.run(programStep(caller, message.task, message.link));
        return toStudent.send({ type: "stored", what: "program", seq: message.seq });
      case "help":
        return found.run(helpStep(caller, message.wanted));
      case "name":
        return found.run(renameStep(caller));
    }
  };
  return {
    received: (text) => {
      const message = valueOf(readStudentMessage(text));
      member.count(message.type);
      if (message.type !== "tile") return store(message);
      member.tile(message.tile);
      return undefined;
    },
    leave: () => member.leave(),
  };
}

function teacherHandler({ hello, grant, connection, clock }: ClassConversationOptions): Handler {
  const { connections } = grant.found;
  const member = connections.joinTeacher(
    typedConnection<RelayToTeacher>(connection),
    hello.since ?? null,
  );
  const rates = new MessageRates(limits.teacherRates, clock);
  return {
    received: (text) => {
      const message = valueOf(decodeTeacherFrame(text));
      if (message.type === "seen") member.seen(message.seq);
      else rates.count(message.type);
      if (message.type === "watch") member.watch(message.student);
      if (message.type === "hint") connections.hint(message.student, message.task, message.hint);
      if (message.type === "display") member.display(message.content, message.priority ?? null);
      return undefined;
    },
    leave: () => member.leave(),
  };
}

function screenHandler({ grant, connection }: ClassConversationOptions): Handler {
  const member = grant.found.connections.joinScreen(typedConnection<RelayToScreen>(connection));
  return {
    received: (text) => {
      member.seen(valueOf(decodeFrame(screenToRelaySchema, text)).seq);
      return undefined;
    },
    leave: () => member.leave(),
  };
}

/** Only a tile has at most 1 KiB. */
function readStudentMessage(text: string): ReadResult<StudentToRelay> {
  const read = decodeFrame(studentToRelaySchema, text);
  const isTooLong = read.ok && read.value.type === "tile" && text.length > MAX_TILE_LENGTH;
  return isTooLong ? decodeFrame(studentToRelaySchema, text, MAX_TILE_LENGTH) : read;
}

/** @throws Refusal bad-request */
function valueOf<T>(read: ReadResult<T>): T {
  if (!read.ok) throw badRequest("Invalid message.", read.problems);
  return read.value;
}
