/** What the teacher sets, as requests to the relay. */
import type { LessonDocument } from "@corridor/challenge/document";
import type { ReturnCode, StudentProgram } from "@corridor/protocol";
import type { Classroom } from "../../simulator/protocol/classroom-messages.ts";

/**
 * old: the page is older than the relay; too-large: the lesson is; too-many: too many classes or
 * requests
 */
export type ClassRefusal = "old" | "offline" | "too-large" | "too-many";

/** the part of fetch that is used */
type Ask = (url: string, request: RequestInit) => Promise<Response>;

const refusals: ReadonlyMap<number, ClassRefusal> = new Map([
  [413, "too-large"],
  [429, "too-many"],
]);

/** The readers of responses load on first use: the dashboard opens without them. */
export class ClassCalls {
  readonly #room: Classroom;
  readonly #ask: Ask;

  constructor(room: Classroom, ask: Ask) {
    this.#room = room;
    this.#ask = ask;
  }

  // Each call resolves with null, or why it had no effect.

  pause(seconds: number): Promise<ClassRefusal | null> {
    return this.#change("PUT", "/pause", { seconds });
  }

  resume(): Promise<ClassRefusal | null> {
    return this.#change("DELETE", "/pause");
  }

  lock(isLocked: boolean): Promise<ClassRefusal | null> {
    return this.#change(isLocked ? "PUT" : "DELETE", "/lock");
  }

  /** @param to null: all tasks are open */
  setPace(to: number | null): Promise<ClassRefusal | null> {
    return to === null ? this.#change("DELETE", "/pace") : this.#change("PUT", "/pace", { to });
  }

  newCode(): Promise<ClassRefusal | null> {
    return this.#change("POST", "/code");
  }

  async sendLesson(lesson: LessonDocument): Promise<ClassRefusal | null> {
    const { lessonBody } = await import("./class-answers.ts");
    return this.#change("PUT", "/lesson", lessonBody(lesson));
  }

  remove(student: number): Promise<ClassRefusal | null> {
    return this.#change("DELETE", `/students/${student}`);
  }

  end(): Promise<ClassRefusal | null> {
    return this.#change("DELETE", "");
  }

  /** null: not possible now */
  async returnCode(student: number): Promise<ReturnCode | null> {
    const text = await this.#read("POST", `/students/${student}/return`);
    if (text === null) return null;
    const { readReturnCode } = await import("./class-answers.ts");
    return readReturnCode(text);
  }

  /** The newest program of a student; null: none, or not possible now */
  async program(student: number): Promise<StudentProgram | null> {
    const text = await this.#read("GET", `/students/${student}/program`);
    if (text === null) return null;
    const { readStudentProgram } = await import("./class-answers.ts");
    return readStudentProgram(text);
  }

  async #change(method: string, path: string, body?: object): Promise<ClassRefusal | null> {
    try {
      const { ok, status } = await this.#send(method, path, body);
      // A class that has ended has no use for the change; its connection says so.
      if (ok || status === 404) return null;
      return refusals.get(status) ?? (status >= 500 ? "offline" : "old");
    } catch {
      return "offline";
    }
  }

  async #read(method: string, path: string): Promise<string | null> {
    try {
      const answer = await this.#send(method, path);
      return answer.ok ? await answer.text() : null;
    } catch {
      return null;
    }
  }

  #send(method: string, path: string, body?: object): Promise<Response> {
    const { id, key } = this.#room;
    return this.#ask(`/api/v1/classes/${id}${path}`, {
      method,
      headers: {
        Authorization: `Bearer ${key}`,
        ...(body !== undefined && { "Content-Type": "application/json" }),
      },
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
  }
}
