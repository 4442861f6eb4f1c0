/** A script's part: it sends commands and gets records, states and snapshots. */
import {
  closeReasons,
  decodeFrame,
  driverToRelaySchema,
  encodeFrame,
  PROTOCOL_VERSION,
  type RelayToDriver,
  type SocketPort,
} from "@corridor/protocol";
import { asRefusal, badRequest, type ProblemKind } from "../problems.ts";
import { limits } from "../sessions/limits.ts";
import type { ReaderSink } from "../sessions/reader-feed.ts";
import type { Grant } from "../sessions/session-hub.ts";
import { closeWith, type Conversation } from "./conversation.ts";

export class DriverConversation implements Conversation {
  readonly #grant: Grant;
  readonly #port: SocketPort;
  readonly #client: string;
  readonly #refused: (kind: ProblemKind) => void;
  readonly #leave: () => void;
  #badFrames = 0;
  #tooFastInARow = 0;

  /**
   * Joins the session as a reader and says welcome.
   * @param client the script's language, such as "Python"
   * @param refused is told of every message that is refused
   * @throws Refusal when too many read already
   */
  constructor(
    grant: Grant,
    port: SocketPort,
    client: string,
    refused: (kind: ProblemKind) => void,
  ) {
    this.#grant = grant;
    this.#port = port;
    this.#client = client;
    this.#refused = refused;
    const { session, key } = grant;
    const sink: ReaderSink = {
      door: "websocket",
      snapshot: (snapshot) => this.#send({ type: "snapshot", snapshot }),
      state: (record) => this.#send({ type: "state", record }),
      over: (reason) => closeWith(port, closeReasons[reason]),
      waitingBytes: () => port.waitingBytes,
    };
    this.#leave = session.join(key, sink);
    session.heard(client);
    this.#send({ type: "welcome", version: PROTOCOL_VERSION, snapshot: session.newest });
  }

  async received(text: string): Promise<void> {
    const { session, key: grant } = this.#grant;
    const message = decodeFrame(driverToRelaySchema, text);
    if (!message.ok) return this.#refuse(badRequest("The message is wrong.", message.problems));
    session.heard(this.#client);
    const { key = null, command } = message.value;
    try {
      await session.submit(grant, { key, command }, (record) => {
        this.#tooFastInARow = 0;
        this.#send({ type: "ack", record });
      });
    } catch (error) {
      const refusal = asRefusal(error);
      if (refusal.kind !== "internal") this.#refused(refusal.kind);
      this.#send({ type: "problem", problem: refusal.problem, key });
      if (refusal.kind === "too-fast") this.#countTooFast();
      // A mistake of the relay goes on to whoever writes the log.
      if (refusal.kind === "internal") throw error;
    }
  }

  heartbeat(): void {
    this.#send({ type: "heartbeat" });
  }

  closed(): void {
    this.#leave();
  }

  #refuse(refusal: ReturnType<typeof badRequest>): void {
    this.#badFrames += 1;
    this.#refused(refusal.kind);
    this.#send({ type: "problem", problem: refusal.problem, key: null });
    if (this.#badFrames >= limits.badFrames) closeWith(this.#port, closeReasons.badFrame);
  }

  #countTooFast(): void {
    this.#tooFastInARow += 1;
    if (this.#tooFastInARow < limits.tooFastInARow) return;
    closeWith(
      this.#port,
      closeReasons.badFrame,
      "Too many commands came too fast. Wait for the ack of each before the next.",
    );
  }

  #send(message: RelayToDriver): void {
    this.#port.send(encodeFrame(message));
  }
}
