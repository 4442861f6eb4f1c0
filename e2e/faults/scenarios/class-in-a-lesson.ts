/** Relays are killed during a lesson: one with its files, and two in turn that share a Redis. */
import { studentProgramSchema } from "@corridor/protocol";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import type { Goal } from "../../../benches/core/goals.ts";
import { ClassTeacher } from "../../support/class-teacher.ts";
import { LessonStudent } from "../classes/lesson-student.ts";
import { machineNow, sleep, waitUntil } from "../clock.ts";
import { startRelayPair } from "../relay-pair.ts";
import type { Transports } from "../robots/page-messages.ts";
import type { Scenario, ScenarioContext } from "../scenario.ts";

const STUDENTS = 10;
const EVERY_MS = 6_000;
const SHORT_KILLS = 6;
const LONG_KILLS = 60;
const LONG_MS = 60_000;

const killsOf = (isLong: boolean): number => (isLong ? LONG_KILLS : SHORT_KILLS);

/** The relays of a class, of which one is killed at a time. */
interface Service {
  name: string;
  origin: string;
  /** of each student in turn */
  transports: readonly Transports[];
  /** ms until a killed relay is started again; 0: at once, and students reconnect to it */
  restartMs: number;
  /** Kills a relay. @returns a function that starts it again */
  kill: (n: number) => Promise<() => Promise<void>>;
}

export const classInALesson: Scenario = {
  title: "Class in a lesson",
  describe: (isLong) =>
    `${STUDENTS} students report progress, programs and tiles, and one more joins at each kill, while a relay is killed (kill -9) ${killsOf(isLong)} times; then the same with two relays on a Redis`,
  run: async (context) => {
    const one = await teach(await oneRelay(context), context);
    const two = await teach(await twoRelays(context), context);
    return [...one, ...two];
  },
};

async function oneRelay(context: ScenarioContext): Promise<Service> {
  const relay = await RelayProcess.start();
  context.onCleanup(() => relay.stop());
  return {
    name: "one relay",
    origin: relay.url,
    transports: ["both", "https"],
    restartMs: 0,
    kill: async () => {
      await relay.kill();
      return () => relay.restart();
    },
  };
}

async function twoRelays(context: ScenarioContext): Promise<Service> {
  const { relays, balancer, origin } = await startRelayPair(context);
  return {
    name: "two relays",
    origin,
    // A long-poll connection is bound to one relay, and this balancer has no session affinity.
    transports: ["websocket"],
    restartMs: EVERY_MS / 2,
    kill: async (n) => {
      const [killed, other] = n % 2 === 0 ? relays : [relays[1], relays[0]];
      await killed.kill();
      balancer.targets = [other.port];
      return async () => {
        await killed.restart();
        balancer.targets = relays.map(({ port }) => port);
      };
    },
  };
}

/** Gives a lesson in which relays are killed, and compares what was confirmed with what is stored. */
async function teach(service: Service, context: ScenarioContext): Promise<Goal[]> {
  const { name, origin, transports, restartMs, kill } = service;
  const random = new SeededRandom(context.seed);
  const teacher = await ClassTeacher.start(origin);
  const students: LessonStudent[] = [];
  const join = async (): Promise<void> => {
    const transport = transports[students.length % transports.length] ?? "both";
    const student = await LessonStudent.join(teacher.code, () => origin, transport);
    students.push(student);
    context.onCleanup(() => student.close());
  };
  for (let n = 0; n < STUDENTS; n++) await join();
  await waitUntil(() => students.every(({ isConnected }) => isConnected), LONG_MS);

  const backMs: number[] = [];
  for (let n = 0; n < killsOf(context.isLong); n++) {
    const next = machineNow() + EVERY_MS;
    await sleep(random.between(500, 2_500));
    const killedAt = machineNow();
    const joining = join();
    const restart = await kill(n);
    if (restartMs === 0) await restart();
    await joining;
    await waitUntil(() => students.every(({ isConnected }) => isConnected), LONG_MS);
    backMs.push(machineNow() - killedAt);
    await sleep(restartMs - (machineNow() - killedAt));
    if (restartMs > 0) await restart();
    await sleep(next - machineNow());
  }
  for (const student of students) student.finish();
  await waitUntil(() => students.every(({ isConfirmed }) => isConfirmed), LONG_MS);
  return [
    ...(await compare(name, students, teacher)),
    {
      label: `${name}: from a kill until all students are connected, slowest`,
      measured: Math.max(...backMs),
      bound: { atMost: 10_000 },
      unit: "ms",
    },
  ];
}

async function compare(
  name: string,
  students: readonly LessonStudent[],
  teacher: ClassTeacher,
): Promise<Goal[]> {
  const stored = new Map((await teacher.read()).students.map((each) => [each.student, each]));
  const known = students.flatMap((student) => {
    const found = stored.get(student.joined.student);
    return found === undefined ? [] : [{ student, found }];
  });
  let wrongRecords = 0;
  let wrongPrograms = 0;
  for (const { student, found } of known) {
    const expected = student.sent.map((event, at) => ({ seq: at + 1, event }));
    const actual = found.progress.map(({ seq, event }) => ({ seq, event }));
    if (JSON.stringify(actual) !== JSON.stringify(expected)) wrongRecords++;
    // The student who joins last may have sent nothing yet.
    if (student.programs.length === 0) continue;
    const path = `/students/${student.joined.student}/program`;
    const { link } = studentProgramSchema.parse(await teacher.get(path));
    if (link !== student.programs.at(-1)) wrongPrograms++;
  }
  const records = students.reduce((sum, { sent }) => sum + sent.length, 0);
  const none = { atMost: 0 };
  return [
    {
      label: `${name}: confirmed joins that are lost`,
      measured: students.length - known.length,
      bound: none,
      unit: `of ${students.length}`,
    },
    {
      label: `${name}: students whose records are not exactly those sent, in order`,
      measured: wrongRecords,
      bound: none,
      unit: `of ${students.length}, ${records} records`,
    },
    {
      label: `${name}: students whose newest program is not stored`,
      measured: wrongPrograms,
      bound: none,
      unit: `of ${students.length}`,
    },
  ];
}
