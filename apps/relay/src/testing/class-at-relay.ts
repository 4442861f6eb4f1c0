/** A class at a relay, for tests: its teacher, big screens and students, who connect by sockets. */
import {
  createdClassSchema,
  joinedClassSchema,
  type CreatedClass,
  type JoinedClass,
  type Tile,
} from "@corridor/protocol";
import { lesson } from "../platform/testing/sample-documents.ts";
import type { AskOptions } from "./test-relay.ts";
import { TestSocket } from "./test-socket.ts";

export const tile: Tile = {
  seq: 1,
  task: 1,
  maze: "g1",
  state: "driving",
  pose: [150, 250.5, 90],
  path: "e4s2",
  line: 1,
  tick: 60,
  bumps: 0,
  passes: null,
};

export class ClassAtRelay {
  readonly #relay: { origin: string };
  readonly created: CreatedClass;

  private constructor(relay: { origin: string }, created: CreatedClass) {
    this.#relay = relay;
    this.created = created;
  }

  static async create(relay: { origin: string }, request: object = {}): Promise<ClassAtRelay> {
    const answer = await post(relay, "/classes", { lesson, ...request });
    return new ClassAtRelay(relay, createdClassSchema.parse(await answer.json()));
  }

  /** The same class at another relay. */
  at(relay: { origin: string }): ClassAtRelay {
    return new ClassAtRelay(relay, this.created);
  }

  /** A request of the teacher to a path below the class. */
  async direct(method: string, path = "", body?: unknown): Promise<Response> {
    return this.ask(path, { method, body });
  }

  /** A request with a key to a path below the class. */
  async ask(path: string, { method, key, body }: AskOptions): Promise<Response> {
    return fetch(`${this.#relay.origin}/api/v1/classes/${this.created.id}${path}`, {
      method: method ?? "GET",
      headers: {
        Authorization: `Bearer ${key ?? this.created.teacherKey}`,
        ...(body !== undefined && { "Content-Type": "application/json" }),
      },
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
  }

  async join(code = this.created.code): Promise<JoinedClass> {
    return joinedClassSchema.parse(await (await post(this.#relay, "/joins", { code })).json());
  }

  /** Connects, and sends a hello without waiting for the response. */
  async connect(role: string, key: string, more: object = {}): Promise<TestSocket> {
    const socket = await TestSocket.at(this.#relay, `/classes/${this.created.id}/socket`);
    socket.send({ type: "hello", version: 1, role, key, ...more });
    return socket;
  }

  /** Connects as a student and waits for the welcome. */
  async student({ key }: JoinedClass) {
    const socket = await this.connect("learn", key);
    return { socket, welcome: await socket.next("welcome") };
  }

  /** Connects a dashboard and waits for the welcome. */
  async teacher(since?: string) {
    const more = since === undefined ? {} : { since };
    const socket = await this.connect("teach", this.created.teacherKey, more);
    return { socket, welcome: await socket.next("welcome") };
  }

  /** Connects a big screen and waits for the welcome. */
  async screen() {
    const socket = await this.connect("show", this.created.screenKey);
    return { socket, welcome: await socket.next("welcome") };
  }
}

async function post({ origin }: { origin: string }, path: string, body: unknown) {
  return fetch(`${origin}/api/v1${path}`, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body),
  });
}
