/** A teacher's script: starts a class at the relay, and directs it as a dashboard does. */
import type { LessonDocument } from "@corridor/challenge";
import {
  classViewSchema,
  createdClassSchema,
  PROTOCOL_VERSION,
  type ClassView,
  type CreatedClass,
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

  get code(): string {
    return this.created.code;
  }

  /** The class with its students. */
  async read(): Promise<ClassView> {
    return classViewSchema.parse(await this.get(""));
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
    const { id, teacherKey: key } = this.created;
    const address = `${this.#relay.replace("http", "ws")}/api/v1/classes/${id}/socket`;
    const socket = new WebSocket(address);
    await new Promise((resolve, reject) => {
      socket.addEventListener("open", resolve);
      socket.addEventListener("error", reject);
    });
    socket.send(JSON.stringify({ type: "hello", version: PROTOCOL_VERSION, role: "teach", key }));
    socket.send(JSON.stringify({ type: "watch", student }));
    return () => socket.close();
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
