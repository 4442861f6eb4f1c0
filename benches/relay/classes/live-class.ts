/** A class at the relay with its students and a dashboard, as the pages connect to it. */
import { StudentConnection } from "@corridor/client/learn";
import type { CreatedClass, JoinedClass } from "@corridor/protocol";
import { globalPlatform, type Platform } from "../../../packages/client/src/platform.ts";
import { sampleLesson } from "../../../apps/web/src/model/lessons/testing/sample-lesson.ts";
import { TextSocket } from "../fleets/text-socket.ts";

export interface ClassAddress {
  /** of the relay */
  port: string;
  /** of all clients of the class, as a proxy reports it */
  client: string;
}

export interface ClassListener {
  /** A student has received the start or the end of a pause. */
  onPause: (student: number, isPaused: boolean) => void;
  /** The dashboard has received a tile. */
  onTile: (student: number, seq: number) => void;
  /** A progress record is stored. */
  onStored: () => void;
}

/** Seconds of a pause, which the benchmark ends itself. */
const PAUSE_SECONDS = 60;
/** close code of a WebSocket that a network blocks */
const CLOSED = 1006;

export class LiveClass {
  readonly #address: ClassAddress;
  readonly #created: CreatedClass;
  readonly #students: TextSocket[] = [];
  readonly #longPollStudents: StudentConnection[] = [];
  #dashboard: TextSocket | null = null;

  private constructor(address: ClassAddress, created: CreatedClass) {
    this.#address = address;
    this.#created = created;
  }

  static async create(address: ClassAddress): Promise<LiveClass> {
    const body = JSON.stringify({ lesson: sampleLesson });
    const created = await request(address, "POST", "/classes", { body });
    return new LiveClass(address, (await created.json()) as CreatedClass);
  }

  /** Joins with the code, and connects. */
  async join(
    onPause: (isPaused: boolean) => void = () => undefined,
    onStored: () => void = () => undefined,
  ): Promise<void> {
    const { key } = await this.#becomeStudent();
    const student = await this.#connect("learn", key, (text) => {
      if (text.startsWith('{"type":"pause"')) onPause(!text.includes(":null"));
      else if (text.startsWith('{"type":"stored"')) onStored();
    });
    this.#students.push(student);
  }

  /** As `join`, on a network that blocks WebSockets. */
  async joinByLongPoll(onPause: (isPaused: boolean) => void): Promise<void> {
    const { class: id, key } = await this.#becomeStudent();
    const connected = Promise.withResolvers<void>();
    const connection = new StudentConnection({
      origin: `http://127.0.0.1:${this.#address.port}`,
      id,
      key,
      onMessage: (message) => {
        if (message.type === "pause") onPause(message.endsInMs !== null);
      },
      onStatus: ({ kind }) => {
        if (kind === "connected") connected.resolve();
      },
      platform: withoutWebSocket,
    });
    this.#longPollStudents.push(connection);
    await connected.promise;
  }

  /** Connects students and the dashboard. */
  async fill(students: number, { onPause, onTile, onStored }: ClassListener): Promise<void> {
    for (let student = 0; student < students; student++) {
      await this.join((isPaused) => onPause(student, isPaused), onStored);
    }
    const key = this.#created.teacherKey;
    this.#dashboard = await this.#connect("teach", key, (text, dashboard) => {
      if (!text.startsWith('{"type":"tiles"')) return;
      const { seq, tiles } = JSON.parse(text) as {
        seq: number;
        tiles: { student: number; tile: { seq: number } | null }[];
      };
      dashboard.send(`{"type":"seen","seq":${seq}}`);
      for (const { student, tile } of tiles) if (tile !== null) onTile(student - 1, tile.seq);
    });
  }

  sendTile(student: number, seq: number): void {
    this.#students[student]?.send(
      `{"type":"tile","tile":{"seq":${seq},"task":1,"maze":"g1","state":"driving","pose":[${100 + (seq % 800)},150,90],"path":"e4s2e3n1e2s5w1s3e6n2e1","line":${(seq % 3) + 1},"tick":${seq * 30},"bumps":0,"passes":null}}`,
    );
  }

  sendProgress(student: number, seq: number): void {
    this.#students[student]?.send(
      `{"type":"progress","seq":${seq},"event":{"kind":"run","task":1,"changed":true,"bumps":1,"mistakes":0,"failure":null}}`,
    );
  }

  async setPaused(isPaused: boolean): Promise<void> {
    const { id, teacherKey: key } = this.#created;
    const body = JSON.stringify({ seconds: PAUSE_SECONDS });
    const [method, content] = isPaused ? ["PUT", { body }] : ["DELETE", {}];
    await request(this.#address, method, `/classes/${id}/pause`, { ...content, key });
  }

  close(): void {
    for (const student of this.#students) student.close();
    for (const student of this.#longPollStudents) student.close();
    this.#dashboard?.close();
  }

  async #becomeStudent(): Promise<JoinedClass> {
    const body = JSON.stringify({ code: this.#created.code });
    const joined = await request(this.#address, "POST", "/joins", { body });
    return (await joined.json()) as JoinedClass;
  }

  async #connect(
    role: "learn" | "teach",
    key: string,
    onMessage: (text: string, socket: TextSocket) => void,
  ): Promise<TextSocket> {
    const welcomed = Promise.withResolvers<void>();
    const socket: TextSocket = await TextSocket.open({
      port: Number(this.#address.port),
      path: `/api/v1/classes/${this.#created.id}/socket`,
      headers: { "X-Forwarded-For": this.#address.client },
      onMessage: (text) =>
        text.startsWith('{"type":"welcome"') ? welcomed.resolve() : onMessage(text, socket),
    });
    socket.send(JSON.stringify({ type: "hello", version: 1, role, key }));
    await welcomed.promise;
    return socket;
  }
}

const withoutWebSocket: Platform = {
  ...globalPlatform(),
  connect: (_url, events) => {
    queueMicrotask(() => events.closed(CLOSED));
    return { send: () => undefined, close: () => undefined, isOpen: false, waitingBytes: 0 };
  },
};

async function request(
  { port, client }: ClassAddress,
  method: string,
  path: string,
  { body, key }: { body?: string; key?: string },
): Promise<Response> {
  const response = await fetch(`http://127.0.0.1:${port}/api/v1${path}`, {
    method,
    headers: {
      "X-Forwarded-For": client,
      ...(body !== undefined && { "Content-Type": "application/json" }),
      ...(key !== undefined && { Authorization: `Bearer ${key}` }),
    },
    ...(body !== undefined && { body }),
  });
  if (!response.ok) throw new Error(`${method} ${path}: ${await response.text()}`);
  return response;
}
