/** A student of a class whose robot drives without end. */
import { lessonMark } from "@corridor/challenge";
import { StudentConnection } from "@corridor/client/learn";
import { joinedClassSchema, type JoinedClass } from "@corridor/protocol";
import { dashboardLesson } from "./dashboard-lesson.ts";
import type { DrivenRobot } from "./driven-robot.ts";

const LESSON = lessonMark(dashboardLesson());

export class RobotStudent {
  readonly #connection: StudentConnection;
  readonly #connected: Promise<void>;
  readonly #robot: DrivenRobot;

  private constructor(relay: string, joined: JoinedClass, robot: DrivenRobot) {
    this.#robot = robot;
    const connection = Promise.withResolvers<void>();
    this.#connected = connection.promise;
    this.#connection = new StudentConnection({
      origin: relay,
      id: joined.class,
      key: joined.key,
      onMessage: () => undefined,
      onStatus: ({ kind }) => {
        if (kind === "connected") connection.resolve();
      },
    });
  }

  /** Joins, and opens the task. */
  static async join(relay: string, code: string, robot: DrivenRobot): Promise<RobotStudent> {
    const answer = await fetch(`${relay}/api/v1/joins`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ code }),
    });
    if (answer.status !== 201) throw new Error(`join: ${answer.status} ${await answer.text()}`);
    const joined = joinedClassSchema.parse(await answer.json());
    const student = new RobotStudent(relay, joined, robot);
    await student.#connected;
    const event = { kind: "opened", lesson: LESSON, task: 1 } as const;
    student.#connection.send({ type: "progress", seq: 1, event });
    return student;
  }

  /** Drives on, and sends a tile if one is due. */
  drive(ms: number): void {
    const tile = this.#robot.drive(ms);
    if (tile !== null) this.#connection.send({ type: "tile", tile });
  }
}
