/**
 * The class that this tab has joined, as the student sees it: connection, name, request for help.
 * A message reports a lost connection and the end of the class. The student's own work stays as it is.
 */
import type { JoinedClass } from "@corridor/protocol";
import type { i18n } from "i18next";
import { createStore } from "zustand/vanilla";
import type {
  ClassEnding,
  ClassRequest,
  ClassSession,
} from "../../simulator/protocol/class-messages.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import { dismiss, showMessage, type Message, type ScreenStore } from "../screen/screen-store.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import {
  removeMembership,
  storedPauseEnd,
  storeMembership,
  storePauseEnd,
} from "./membership.ts";

/** A connection that is lost for less than this is not worth a message, in ms. */
const LOST_MS = 3_000;

export interface StudentClassPorts {
  simulator: Pick<SimulatorClient, "send" | "listen">;
  screen: ScreenStore;
  /** sessionStorage */
  tab: KeyValueStorage;
  words: Pick<i18n, "t">;
  /** milliseconds since 1970 */
  now: () => number;
  /** @param endsAt end of the pause, in milliseconds since 1970; null: it is over */
  onPause: (endsAt: number | null) => void;
  /** The student has left, was removed, or the class has ended. */
  onEnd: () => void;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

const connecting: ClassSession = { status: { kind: "connecting" }, student: null };

export class StudentClass {
  /** as the worker last sent it */
  readonly session = createStore<ClassSession>()(() => connecting);
  readonly #ports: StudentClassPorts;
  #joined: JoinedClass;
  readonly #unsubscribe: () => void;
  #cancelLost: (() => void) | null = null;
  /** id of the message about the connection; null: none */
  #message: number | null = null;
  #pauseEndsAt: number | null = null;
  #cancelPause: () => void = () => undefined;

  /** Connects at once. */
  constructor(ports: StudentClassPorts, joined: JoinedClass) {
    this.#ports = ports;
    this.#joined = joined;
    this.#unsubscribe = ports.simulator.listen((message) => {
      if (message.type === "class") this.#receive(message.session);
    });
    this.#followPause(storedPauseEnd(ports.tab));
    this.#connect();
  }

  /** The newest name of the student, also before the first connection. */
  get name(): JoinedClass["name"] {
    return this.#joined.name;
  }

  /** The device is online again: reconnects at once. */
  reconnect(): void {
    if (this.session.getState().status.kind === "lost") this.#connect();
  }

  /** Takes the class back from another tab or device. */
  continueHere(): void {
    this.#endMessage();
    this.#connect();
  }

  askForHelp(wanted: boolean): void {
    this.#request({ kind: "help", wanted });
  }

  requestName(): void {
    this.#request({ kind: "name" });
  }

  /** Disconnects for good: this tab discards the key of the student. */
  leave(): void {
    this.#request({ kind: "close" });
    this.#end();
  }

  #connect(): void {
    this.#request({ kind: "open", id: this.#joined.class, key: this.#joined.key });
  }

  #request(request: ClassRequest): void {
    this.#ports.simulator.send({ type: "class", request });
  }

  #receive(session: ClassSession): void {
    const { status, student } = session;
    if (student !== null && !isSameName(student.name, this.name)) {
      this.#joined = { ...this.#joined, name: student.name };
      storeMembership(this.#ports.tab, this.#joined);
    }
    this.session.setState(session);
    if (status.kind === "over") this.#followPause(null);
    else if (student !== null) this.#followPause(student.pauseEndsAt);
    if (status.kind === "over") this.#over(status.reason);
    else if (status.kind === "connected") this.#endMessage();
    else if (status.kind === "lost") this.#lost();
  }

  /** The clock ends the pause, also without a connection. */
  #followPause(endsAt: number | null): void {
    if (endsAt === this.#pauseEndsAt) return;
    const wasPaused = this.#pauseEndsAt !== null;
    this.#cancelPause();
    const { screen, words, now, later } = this.#ports;
    const leftMs = endsAt === null ? 0 : endsAt - now();
    this.#pauseEndsAt = leftMs > 0 ? endsAt : null;
    if (leftMs > 0) {
      this.#cancelPause = later(() => this.#followPause(null), leftMs);
      return this.#setPause();
    }
    if (!wasPaused) return;
    this.#setPause();
    if (this.session.getState().status.kind === "over") return;
    showMessage(screen, { tone: "info", text: words.t("join:inClass.pauseOver") });
  }

  #setPause(): void {
    const { simulator, tab, onPause } = this.#ports;
    simulator.send({ type: "class-pause", isPaused: this.#pauseEndsAt !== null });
    storePauseEnd(tab, this.#pauseEndsAt);
    onPause(this.#pauseEndsAt);
  }

  #lost(): void {
    if (this.#message !== null) return;
    this.#cancelLost ??= this.#ports.later(
      () => this.#show({ tone: "info", text: this.#ports.words.t("join:inClass.lost") }),
      LOST_MS,
    );
  }

  #over(reason: ClassEnding): void {
    const { t } = this.#ports.words;
    const text = t(`join:inClass.${reason}`);
    if (reason !== "replaced") {
      this.#end();
      showMessage(this.#ports.screen, { tone: "info", text, stays: true });
      return;
    }
    const action = { label: t("join:inClass.continueHere"), run: () => this.continueHere() };
    this.#show({ tone: "info", text, action });
  }

  #end(): void {
    this.#endMessage();
    this.#cancelPause();
    this.#unsubscribe();
    if (this.#pauseEndsAt !== null) {
      this.#pauseEndsAt = null;
      this.#setPause();
    }
    removeMembership(this.#ports.tab);
    this.#ports.onEnd();
  }

  #show(message: Omit<Message, "id">): void {
    this.#endMessage();
    this.#message = showMessage(this.#ports.screen, { ...message, stays: true });
  }

  #endMessage(): void {
    this.#cancelLost?.();
    this.#cancelLost = null;
    if (this.#message !== null) dismiss(this.#ports.screen, this.#message);
    this.#message = null;
  }
}

function isSameName(one: JoinedClass["name"], other: JoinedClass["name"]): boolean {
  return one.word === other.word && one.text === other.text;
}
