/** The students of a class, in a process separate from the browser. Ends with its parent. */
import { UNSEEN_MAZES } from "./dashboard-lesson.ts";
import { DrivenRobot } from "./driven-robot.ts";
import { RobotStudent } from "./robot-student.ts";

export interface StudentsJob {
  /** address of the relay */
  relay: string;
  /** of the class */
  code: string;
  students: number;
}

const STEP_MS = 50;
const TIMER_MS = 5;
/** Number of runs of different ages. */
const RUNS = 40;
/** The run of each student is this much older than that of the one before, in ms. */
const APART_MS = 1_730;

process.on("message", (job: StudentsJob) => {
  start(job).then(
    () => process.send?.("ready"),
    (error: unknown) => {
      console.error(error);
      process.exit(1);
    },
  );
});
process.on("disconnect", () => process.exit(0));

async function start({ relay, code, students }: StudentsJob): Promise<void> {
  const all: RobotStudent[] = [];
  for (let n = 0; n < students; n++) {
    // Every other student drives in unseen mazes, each in another one.
    const unseen = n % 2 === 0 ? null : (n % UNSEEN_MAZES) + 1;
    const robot = new DrivenRobot((n % RUNS) * APART_MS, unseen);
    all.push(await RobotStudent.join(relay, code, robot));
  }
  let drivenTo = performance.now();
  let next = 0;
  setInterval(() => {
    const now = performance.now();
    // One after the other, so that their tiles do not arrive at once.
    for (; drivenTo + STEP_MS / students <= now; drivenTo += STEP_MS / students) {
      all[next++ % students]?.drive(STEP_MS);
    }
  }, TIMER_MS);
}
