import { lessonMark, runCheckUnit, type Attempt, type LessonDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { describe, expect, it } from "vitest";
import type { PoolListener, WorkerPool } from "../../simulator/worker-pool.ts";
import type { TaskWork } from "../../simulator/protocol/classroom-messages.ts";
import { answers } from "../lessons/missions/testing/answers.ts";
import { sampleLesson } from "../lessons/testing/sample-lesson.ts";
import { SolutionVerifier, type Verifications } from "./verifier.ts";

const { solution, wrong } = answers["one-line"];

function codeOf(attempt: Attempt, lesson: LessonDocument = sampleLesson, task = 0): string {
  const link = encodeLink({ completion: { lesson: lessonMark(lesson), task, attempt } });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

/** A student who claims to have solved the first task with these codes. */
function claiming(...codes: (string | null)[]) {
  const claims = codes.map((code) => ({ code, activeAt: 1, lines: 1, attempts: 1 }));
  const work: TaskWork = {
    task: 1,
    openedAt: 0,
    claims,
    attempts: 1,
    runs: 0,
    bumps: 0,
    failedChecks: 0,
    hints: 0,
    mistakes: 0,
    failures: [],
  };
  return { tasks: [work] };
}

/** A verifier whose pool runs a job when the test asks for it. */
function newVerifier() {
  const jobs: (() => void)[] = [];
  let current: Verifications = new Map();
  const pool: Pick<WorkerPool, "run" | "stop"> = {
    stop: () => undefined,
    run: (job, count, listener: PoolListener) => {
      jobs.push(() => {
        if (job.kind !== "check") return;
        for (let unit = 0; unit < count; unit++) {
          listener.onResult({ kind: "check", outcome: runCheckUnit(job.check, unit) }, unit);
        }
      });
    },
  };
  const verifier = new SolutionVerifier(
    pool,
    () => undefined,
    (each) => (current = each),
  );
  return {
    verifier,
    jobs,
    kindOf: (student: number) => current.get(student)?.get(1)?.kind,
    runAll: (): void => {
      for (let job = jobs.shift(); job !== undefined; job = jobs.shift()) job();
    },
  };
}

describe("a claimed solution", () => {
  it("passes only after it was run", () => {
    const { verifier, kindOf, runAll } = newVerifier();
    verifier.follow(sampleLesson, new Map([[1, claiming(codeOf(solution))]]));
    expect(kindOf(1)).toBe("checking");
    runAll();
    expect(kindOf(1)).toBe("passes");
  });

  it.each([
    { what: "a program that does not pass", code: codeOf(wrong.attempt) },
    { what: "a code of another task", code: codeOf(solution, sampleLesson, 1) },
    { what: "a text that is no code", code: "hello" },
  ])("does not count for $what", ({ code }) => {
    const { verifier, kindOf, runAll } = newVerifier();
    verifier.follow(sampleLesson, new Map([[1, claiming(code)]]));
    runAll();
    expect(kindOf(1)).toBe("fails");
  });

  it("counts if another claim of the student does not pass", () => {
    const { verifier, kindOf, runAll } = newVerifier();
    const student = claiming(codeOf(wrong.attempt), codeOf(solution));
    verifier.follow(sampleLesson, new Map([[1, student]]));
    runAll();
    expect(kindOf(1)).toBe("passes");
  });

  it("stays unchecked without a code, until another one passes", () => {
    const { verifier, kindOf, runAll } = newVerifier();
    verifier.follow(sampleLesson, new Map([[1, claiming(codeOf(wrong.attempt), null)]]));
    runAll();
    expect(kindOf(1)).toBe("unchecked");
    verifier.follow(sampleLesson, new Map([[1, claiming(null, codeOf(solution))]]));
    runAll();
    expect(kindOf(1)).toBe("passes");
  });

  it("is run once, even if several students claim it", () => {
    const { verifier, jobs, kindOf, runAll } = newVerifier();
    const code = codeOf(solution);
    verifier.follow(sampleLesson, new Map([[1, claiming(code)]]));
    runAll();
    verifier.follow(
      sampleLesson,
      new Map([
        [1, claiming(code)],
        [2, claiming(code)],
      ]),
    );
    expect(jobs).toEqual([]);
    expect(kindOf(2)).toBe("passes");
  });

  it("of an earlier lesson is neither right nor wrong", () => {
    const { verifier, kindOf } = newVerifier();
    const other = { ...sampleLesson, name: "Another lesson" };
    verifier.follow(other, new Map([[1, claiming(codeOf(solution))]]));
    expect(kindOf(1)).toBeUndefined();
  });
});
