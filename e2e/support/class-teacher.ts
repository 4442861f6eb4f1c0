/** A teacher's script: starts a class at the relay, and directs it as a dashboard does. */
import type { LessonDocument } from "@corridor/challenge";
import {
  classViewSchema,
  createdClassSchema,
  decodeFrame,
  PROTOCOL_VERSION,
  relayToTeacherSchema,
  type ClassView,
  type CreatedClass,
  type Progress,
  type TeacherToRelay,
  type Tile,
} from "@corridor/protocol";
import { sampleLesson } from "../../apps/web/src/model/lessons/testing/sample-lesson.ts";

export class ClassTeacher {
  readonly #relay: string;
  readonly created: CreatedClass;

  private constructor(relay: string, created: CreatedClass) {
    this.#relay = relay;
    this.created = created;
  }

  static async start(
    relay: string,
    names: string[] | null = null,
    lesson: LessonDocument = sampleLesson,
  ): Promise<ClassTeacher> {
    const answer = await fetch(`${relay}/api/v1/classes`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ lesson, names }),
    });
    return new ClassTeacher(relay, createdClassSchema.parse(await answer.json()));
  }

  /** Directs a class that a page has started. */
  static of(relay: string, created: CreatedClass): ClassTeacher {
    return new ClassTeacher(relay, created);
  }

  get code(): string {
    return this.created.code;
  }

  /** The address of the dashboard. @param search such as ?lang=ar */
  address(search = ""): string {
    const { id, teacherKey } = this.created;
    return `${this.#relay}/class/${id}${search}#${teacherKey}`;
  }

  /** The class with its students. */
  async read(): Promise<ClassView> {
    return classViewSchema.parse(await this.get(""));
  }

  /** The stored progress of the first student, in order. */
  async progress(): Promise<Progress[]> {
    return ((await this.read()).students[0]?.progress ?? []).map(({ event }) => event);
  }

  /** Reads a part of the class. @param path below the class */
  async get(path: string): Promise<unknown> {
    return (await this.#request("GET", path)).json();
  }

  /** A request with the teacher's key. @param path below the class */
  async direct(method: "DELETE" | "PUT", path = "", body?: object): Promise<void> {
    await this.#request(method, path, body);
  }

  /** Watches a student, as a dashboard does. @returns a function that ends it */
  async watch(student: number): Promise<() => void> {
    const dashboard = await this.connect();
    dashboard.send({ type: "watch", student });
    return () => dashboard.close();
  }

  /** Connects as a dashboard. */
  async connect(): Promise<Dashboard> {
    const { id, teacherKey: key } = this.created;
    const address = `${this.#relay.replace("http", "ws")}/api/v1/classes/${id}/socket`;
    const socket = new WebSocket(address);
    await new Promise((resolve, reject) => {
      socket.addEventListener("open", resolve);
      socket.addEventListener("error", reject);
    });
    socket.send(JSON.stringify({ type: "hello", version: PROTOCOL_VERSION, role: "teach", key }));
    return new Dashboard(socket);
  }

  async #request(method: string, path: string, body?: object): Promise<Response> {
    const { id, teacherKey } = this.created;
    const answer = await fetch(`${this.#relay}/api/v1/classes/${id}${path}`, {
      method,
      headers: {
        Authorization: `Bearer ${teacherKey}`,
        ...(body !== undefined && { "Content-Type": "application/json" }),
      },
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
    if (!answer.ok) throw new Error(`${method} ${path}: ${answer.status} ${await answer.text()}`);
    return answer;
  }
}

/** The tiles that a dashboard receives. */
export class Dashboard {
  readonly #socket: WebSocket;
  /** all tiles of the first student */
  readonly tiles: Tile[] = [];

  constructor(socket: WebSocket) {
    this.#socket = socket;
    socket.addEventListener("message", ({ data }) => this.#receive(String(data)));
  }

  /** The newest tile of the first student. */
  get tile(): Tile | null {
    return this.tiles.at(-1) ?? null;
  }

  send(message: TeacherToRelay): void {
    this.#socket.send(JSON.stringify(message));
  }

  close(): void {
    this.#socket.close();
  }

  #receive(text: string): void {
    const read = decodeFrame(relayToTeacherSchema, text);
    if (!read.ok || read.value.type !== "tiles") return;
    this.send({ type: "seen", seq: read.value.seq });
    for (const { student, tile } of read.value.tiles) {
      if (student === 1 && tile !== null) this.tiles.push(tile);
    }
  }
}
