/** A student of a class as a script: the messages that the page of a student would send. */
import { StudentConnection, type ClassMessage } from "@corridor/client/learn";
import { joinedClassSchema, type JoinedClass, type Progress, type Tile } from "@corridor/protocol";

const start: Omit<Tile, "seq"> = {
  task: 1,
  maze: "g1",
  state: "writing",
  pose: [50, 650, 90],
  path: "",
  line: null,
  tick: 0,
  bumps: 0,
  passes: null,
};

export class ScriptedStudent {
  readonly joined: JoinedClass;
  readonly received: ClassMessage[] = [];
  readonly #connection: StudentConnection;
  #tile: Tile = { seq: 0, ...start };
  #progress = 0;
  #programs = 0;

  static async join(relay: string, code: string): Promise<ScriptedStudent> {
    const answer = await fetch(`${relay}/api/v1/joins`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ code }),
    });
    if (answer.status !== 201) throw new Error(`join: ${answer.status} ${await answer.text()}`);
    const student = new ScriptedStudent(relay, joinedClassSchema.parse(await answer.json()));
    await student.#connected;
    return student;
  }

  readonly #connected: Promise<void>;

  private constructor(relay: string, joined: JoinedClass) {
    this.joined = joined;
    const connection = Promise.withResolvers<void>();
    this.#connected = connection.promise;
    this.#connection = new StudentConnection({
      origin: relay,
      id: joined.class,
      key: joined.key,
      onMessage: (message) => this.received.push(message),
      onStatus: ({ kind }) => {
        if (kind === "connected") connection.resolve();
      },
    });
  }

  /** Whether the student's page has received such a message. */
  has(type: ClassMessage["type"]): boolean {
    return this.received.some((message) => message.type === type);
  }

  /** Sends a tile with these changes. */
  show(change: Partial<Omit<Tile, "seq">>): void {
    this.#tile = { ...this.#tile, ...change, seq: this.#tile.seq + 1 };
    this.#connection.send({ type: "tile", tile: this.#tile });
  }

  /** Reports progress. The relay accepts 10 records at once, and then one in 2 s. */
  report(event: Progress): void {
    this.#progress += 1;
    this.#connection.send({ type: "progress", seq: this.#progress, event });
  }

  /** Stores the link text of a program. */
  write(link: string, task = 1): void {
    this.#programs += 1;
    this.#connection.send({ type: "program", seq: this.#programs, task, link });
  }

  askForHelp(wanted = true): void {
    this.#connection.send({ type: "help", wanted });
  }

  /** Reports a run that bumped, of a changed program. */
  bump(line: number, task = 1): void {
    const failure = { code: "bump", line };
    const bumpPlaces = [{ maze: "g1", column: 3, row: 1 }];
    const run = { task, changed: true, bumps: 1, bumpPlaces, mistakes: 0, failure } as const;
    this.report({ kind: "run", ...run });
  }

  close(): void {
    this.#connection.close();
  }
}
