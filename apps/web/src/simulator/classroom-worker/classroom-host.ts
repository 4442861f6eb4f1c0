/** The dashboard's connection to a class: reads it, follows its events, and reads its lessons. */
import {
  TeacherConnection,
  type TeacherMessage,
  type TeacherConnectionOptions,
} from "@corridor/client/teach";
import { lessonMark, readLesson } from "@corridor/challenge";
import {
  classViewSchema,
  closeReasons,
  readJson,
  type ClassEvent,
  type ClassSettings,
  type ClassView,
  type TeacherToRelay,
} from "@corridor/protocol";
import { activeMsAt, withPause } from "../protocol/class-time.ts";
import type {
  Classroom,
  ClassroomState,
  ClassTime,
  FromClassroom,
} from "../protocol/classroom-messages.ts";
import { Roster } from "./roster.ts";

const RETRY_MS = 2_000;
/** Interval between two updates of the page. */
const POST_MS = 250;
/** 200 students with 5,000 records each would be larger, but no lesson is that long. */
const MAX_VIEW_LENGTH = 64 * 1_024 * 1_024;
/** The longest life of a class, in s. */
const LIFE_SECONDS = 12 * 3_600;

/** Statuses of a request after which the key does not work any more. */
const refusals = new Set([401, 403]);

export interface ClassroomPorts {
  origin: string;
  /** ms since 1970 */
  now(): number;
  /** Calls once after `ms`. @returns a function that cancels the call */
  after(ms: number, call: () => void): () => void;
  /** Sends a GET request with the key. @throws if there is no response */
  read(path: string, key: string): Promise<{ status: number; text: string }>;
  post(message: FromClassroom): void;
  /** The picture of these students may have changed. */
  onTiles(students: readonly number[]): void;
  /** default: the worker's own */
  platform?: NonNullable<TeacherConnectionOptions["platform"]>;
}

export class ClassroomHost {
  readonly #ports: ClassroomPorts;
  readonly #room: Classroom;
  readonly roster: Roster;
  #connection: TeacherConnection | null = null;
  #view: Pick<ClassView, "expected"> & { createdAt: number } = { expected: null, createdAt: 0 };
  #settings: ClassSettings | null = null;
  #time: ClassTime = { at: 0, activeMs: 0, pauseEndsAt: null, ahead: 0 };
  /** events that arrive while the class is read; null: it is not read now */
  #queued: ClassEvent[] | null = null;
  /** a gap arrived while the class was read: that response may be older than the gap */
  #isOutdated = false;
  /** version of the lesson that the page has or receives soon */
  #lesson: string | null = null;
  /** the student whom the teacher watches; null: none */
  #watched: number | null = null;
  #cancelPost: (() => void) | null = null;
  #isOver = false;

  /** Connects at once. */
  constructor(room: Classroom, ports: ClassroomPorts) {
    this.#room = room;
    this.#ports = ports;
    this.roster = new Roster(() => activeMsAt(this.#time, ports.now()));
    ports.post({ type: "status", status: { kind: "connecting" } });
    void this.#read();
  }

  /** Reconnects at once instead of waiting for the next attempt. */
  again(): void {
    this.#connection?.open();
  }

  /** Sends a message to the relay; drops it while there is no connection. */
  send(message: TeacherToRelay): void {
    if (message.type === "watch") {
      this.#watched = message.student;
      this.roster.watch(message.student);
      this.#postSoon();
    }
    this.#connection?.send(message);
  }

  /** Reads the class, and connects after the first time. */
  async #read(): Promise<void> {
    this.#queued ??= [];
    this.#isOutdated = false;
    const text = await this.#get("");
    if (text === null) return;
    const read = readJson(classViewSchema, text, MAX_VIEW_LENGTH);
    if (!read.ok) return this.#end("refused");
    const view = read.value;
    const now = this.#ports.now();
    this.#view = {
      expected: view.expected,
      createdAt: now - (LIFE_SECONDS - view.endsInSeconds) * 1_000,
    };
    const time = { at: now, activeMs: view.activeMs, pauseEndsAt: null };
    this.#time = { ...time, ahead: now - Date.parse(view.now) };
    this.#setSettings(view.settings);
    this.roster.replace(view);
    const newest = numberOf(view.since);
    for (const event of this.#queued ?? []) if (event.n > newest) this.#follow(event);
    this.#queued = null;
    if (this.#isOutdated) void this.#read();
    this.#postSoon();
    this.#connection ??= new TeacherConnection({
      origin: this.#ports.origin,
      id: this.#room.id,
      key: this.#room.key,
      since: view.since,
      onMessage: (message) => this.#received(message),
      onStatus: (status) => {
        if (status.kind === "over") {
          this.#end(status.reason.code === closeReasons.over.code ? "over" : "refused");
        } else this.#ports.post({ type: "status", status: { kind: status.kind } });
      },
      ...(this.#ports.platform !== undefined && { platform: this.#ports.platform }),
    });
  }

  #received(message: TeacherMessage): void {
    switch (message.type) {
      case "welcome":
        // To the relay, a new connection watches nobody.
        if (this.#watched !== null) this.send({ type: "watch", student: this.#watched });
        return this.#setSettings(message.settings);
      case "tiles":
        this.#ports.onTiles(this.roster.show(message.tiles));
        return this.#postSoon();
      case "student":
      case "removed":
      case "settings":
        if (this.#queued !== null) this.#queued.push(message);
        else this.#follow(message);
        return;
      case "gap":
        if (this.#queued === null) void this.#read();
        else this.#isOutdated = true;
        return;
      case "displayed":
        return this.#ports.post(message);
      case "problem":
        return;
    }
  }

  #follow(event: ClassEvent): void {
    if (event.type === "settings") return this.#setSettings(event.settings);
    this.roster.follow(event);
    this.#postSoon();
  }

  #setSettings(settings: ClassSettings): void {
    this.#settings = settings;
    this.#time = withPause(this.#time, this.#ports.now(), settings.pauseEndsInMs);
    this.#ports.post({ type: "state", state: this.#state(settings) });
    if (settings.lesson === this.#lesson) return;
    if (this.#lesson !== null) {
      this.roster.restart();
      this.#postSoon();
    }
    this.#lesson = settings.lesson;
    void this.#readLesson(settings.lesson);
  }

  #state({ code, locked, paceTo }: ClassSettings): ClassroomState {
    const { expected, createdAt } = this.#view;
    return { settings: { code, locked, paceTo }, expected, createdAt, time: this.#time };
  }

  async #readLesson(version: string): Promise<void> {
    const text = await this.#get("/lesson");
    if (text === null || this.#settings?.lesson !== version) return;
    const read = readLesson(text);
    if (!read.ok) return;
    this.#ports.post({ type: "lesson", lesson: read.value, version });
    this.roster.setLesson(lessonMark(read.value));
    this.#post();
  }

  /** Reads a part of the class until there is a response. @returns null if the class has ended */
  async #get(path: string): Promise<string | null> {
    const { id, key } = this.#room;
    for (;;) {
      if (this.#isOver) return null;
      try {
        const { status, text } = await this.#ports.read(`/api/v1/classes/${id}${path}`, key);
        if (status === 200) return text;
        if (status === 404) this.#end("over");
        else if (refusals.has(status)) this.#end("refused");
      } catch {
        // The network may come back.
      }
      if (this.#isOver) return null;
      if (this.#connection === null) this.#ports.post({ type: "status", status: { kind: "lost" } });
      await new Promise<void>((resolve) => this.#ports.after(RETRY_MS, resolve));
    }
  }

  #end(kind: "over" | "refused"): void {
    if (this.#isOver) return;
    this.#isOver = true;
    this.#connection?.close();
    this.#post();
    this.#ports.post({ type: "status", status: { kind } });
  }

  #postSoon(): void {
    this.#cancelPost ??= this.#ports.after(POST_MS, () => this.#post());
  }

  #post(): void {
    this.#cancelPost?.();
    this.#cancelPost = null;
    if (this.roster.hasChanges) {
      this.#ports.post({ type: "students", ...this.roster.takeChanges() });
    }
    const bumps = this.roster.takeBumps();
    if (bumps !== null) this.#ports.post({ type: "bumps", bumps });
  }
}

/** The number of the event that `since` names. */
function numberOf(since: string): number {
  return Number(since.slice(since.indexOf("-") + 1));
}
