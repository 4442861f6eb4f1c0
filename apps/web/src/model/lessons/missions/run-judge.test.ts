import {
  checkChallenge,
  type Attempt,
  type ChallengeDocument,
  type Judgement,
  type MazeOutcome,
} from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import { Recording } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { challengeOf } from "./mission.ts";
import { missions } from "./missions.ts";
import { answers } from "./testing/answers.ts";
import { RunJudge } from "../../../simulator/worker/run-judge.ts";
import { RunLoop } from "../../../simulator/worker/run-loop.ts";
import type { Speed } from "../../../simulator/protocol/worker-messages.ts";

type Outcome = Exclude<Judgement, { kind: "open" }>;

function challengeOfMission(id: string): ChallengeDocument {
  const mission = missions.find((each) => each.id === id);
  if (mission === undefined) throw new Error(`no mission ${id}`);
  return challengeOf(mission, id, { task: "", short: "", hints: [] });
}

const nothing: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

/** Final judgement of an attempt at one maze; null if it stays open. */
function judged(challenge: ChallengeDocument, maze: number, attempt: Attempt): Outcome | null {
  const document = challenge.mazes[maze];
  if (document === undefined) throw new Error("no such maze");
  const isHand = !("rules" in attempt);
  const recording = new Recording(document, isHand ? nothing : attempt);
  const judge = new RunJudge(challenge, maze);
  judge.begin(recording);
  const { run } = recording;
  if (isHand) recording.addInput({ do: "driver", driver: "me" });
  const commands = isHand ? [...attempt] : [];
  let outcome: Outcome | null = null;
  while (run.tick <= challenge.checks.seconds * 60 && outcome === null) {
    while (commands[0]?.tick === run.tick) {
      const [next] = commands.splice(0, 1);
      if (next !== undefined) recording.addInput({ do: "command", command: next.command });
    }
    judge.before(run);
    recording.step();
    judge.after(run);
    const judgement = judge.take(run, false);
    if (judgement !== null && judgement.kind !== "open") outcome = judgement;
  }
  return outcome;
}

/** Expected judgement for the outcome of a check, except for the driver. */
function expectedOf({ failure, ticks, bumps }: MazeOutcome): object {
  if (failure === null) return { kind: "met", tick: ticks, bumps };
  const isBump = failure.code === "bump";
  return { kind: "failed", code: isBump ? "bump" : "late", tick: isBump ? ticks : ticks + 1 };
}

/** A stop may be detected one tick earlier or later. */
function withinATick(judgement: Outcome | null, tick: number): object | null {
  if (judgement?.kind !== "met") return judgement;
  const { driver: _, ...met } = judgement;
  return Math.abs(met.tick - tick) <= 1 ? { ...met, tick } : met;
}

/** A loop with a judge; real time passes in steps of one frame. */
class Bench {
  time = 0;
  readonly loop: RunLoop;
  judgement: Judgement = { kind: "open" };

  constructor(
    challenge: ChallengeDocument,
    program: ProgramDocument = challenge.program ?? nothing,
    maze = 0,
  ) {
    const document = challenge.mazes[maze];
    if (document === undefined) throw new Error("no such maze");
    this.loop = new RunLoop(document, program, () => (this.time += 0.5));
    this.loop.updates.judgeBy(new RunJudge(challenge, maze));
  }

  pass(milliseconds: number, each = 100): Judgement {
    for (const end = this.time + milliseconds; this.time < end;) {
      this.time += each;
      this.loop.advance();
      this.look();
    }
    return this.judgement;
  }

  /** Presses Run until the attempt is decided, because a bump's card pauses it. */
  runThrough(speed: Speed): Judgement {
    this.loop.setSpeed(speed);
    for (let n = 0; n < 2000 && this.judgement.kind === "open"; n++) {
      if (!this.loop.isRunning) this.loop.run();
      this.pass(100);
    }
    return this.judgement;
  }

  look(): Judgement {
    this.judgement = this.loop.updates.takeJudgement() ?? this.judgement;
    return this.judgement;
  }
}

describe("the judge of the run", () => {
  const attempts = missions.flatMap(({ id }) => {
    const challenge = challengeOfMission(id);
    const { solution, wrong } = answers[id];
    return challenge.mazes.flatMap((_, maze) => [
      { id, challenge, maze, what: "solution", attempt: solution },
      { id, challenge, maze, what: "typical wrong answer", attempt: wrong.attempt },
    ]);
  });

  it.each(attempts)(
    "agrees with the check: $id, maze $maze, $what",
    ({ challenge, maze, attempt }) => {
      const verdict = checkChallenge(challenge, attempt);
      const outcome = verdict.mazes[maze];
      // A check does not run a program that is not allowed.
      if (outcome === undefined) return;
      expect(withinATick(judged(challenge, maze, attempt), outcome.ticks)).toEqual(
        expectedOf(outcome),
      );
    },
  );

  const lap: ChallengeDocument = {
    ...challengeOfMission("right-wall"),
    checks: { bumps: null, seconds: 600 },
  };

  it.each<Speed>([1, 16, "max"])("meets the goal at the same tick at speed %s", (speed) => {
    const { solution } = answers["right-wall"];
    const [outcome] = checkChallenge(lap, solution).mazes;
    const bench = new Bench(lap, solution as ProgramDocument);
    expect(bench.runThrough(speed)).toMatchObject({ kind: "met", tick: outcome?.ticks });
  });

  it.each<Speed>([1, 16, "max"])("is not late at speed %s where the check is not", (speed) => {
    const { solution } = answers["right-wall"];
    const [outcome] = checkChallenge(lap, solution).mazes;
    // As many whole seconds as the lap takes, and not one more.
    const seconds = Math.ceil((outcome?.ticks ?? 0) / 60);
    const tight = { ...lap, checks: { bumps: null, seconds } };
    const bench = new Bench(tight, solution as ProgramDocument);
    expect(bench.runThrough(speed)).toMatchObject({ kind: "met" });
  });

  it.each<Speed>([1, 16, "max"])(
    "counts visited squares at speed %s as the check does",
    (speed) => {
      const visit: ChallengeDocument = {
        ...lap,
        goal: { kind: "visit" },
        checks: { bumps: null, seconds: 60 },
      };
      const { solution } = answers["right-wall"];
      const [outcome] = checkChallenge(visit, solution).mazes;
      const bench = new Bench(visit, solution as ProgramDocument);
      const found = bench.runThrough(speed);
      const expected = outcome?.failure === null ? "met" : "failed";
      expect(found).toMatchObject({
        kind: expected,
        tick: (outcome?.ticks ?? 0) + (expected === "met" ? 0 : 1),
      });
    },
  );

  it("continues from an earlier tick as if the later ones had never happened", () => {
    const { solution } = answers["right-wall"];
    const [outcome] = checkChallenge(lap, solution).mazes;
    const bench = new Bench(lap, solution as ProgramDocument);
    expect(bench.runThrough("max").kind).toBe("met");
    bench.loop.seek(200);
    // The displayed past is no attempt: a met goal stays met until it is truncated.
    expect(bench.look().kind).toBe("met");
    bench.loop.run();
    expect(bench.look()).toEqual({ kind: "open" });
    expect(bench.runThrough(1)).toMatchObject({ kind: "met", tick: outcome?.ticks });
  });

  it("still knows after a truncation who drove before it", () => {
    const bench = new Bench(
      challengeOfMission("right-wall"),
      answers["right-wall"].solution as ProgramDocument,
    );
    bench.loop.hold("forward");
    bench.pass(500);
    bench.loop.hold("stop");
    const { tick } = bench.loop.snapshot();
    bench.loop.run();
    bench.pass(500);
    bench.loop.seek(tick + 5);
    expect(bench.runThrough("max")).toMatchObject({ kind: "failed", code: "driver" });
  });

  it("judges the existing part of a run when the challenge opens in between", () => {
    const { solution } = answers["right-wall"];
    const [outcome] = checkChallenge(lap, solution).mazes;
    const bench = new Bench(lap, solution as ProgramDocument);
    bench.loop.updates.judgeBy(null);
    bench.loop.run();
    bench.pass(3000);
    bench.loop.updates.judgeBy(new RunJudge(lap, 0));
    expect(bench.runThrough("max")).toMatchObject({ kind: "met", tick: outcome?.ticks });
  });

  it("takes a stop at the tick at which the check takes it, also after a turn", () => {
    const program: ProgramDocument = {
      ...nothing,
      rules: [
        { when: { sensor: "back", is: "<", than: 51 }, do: "delayed right 90" },
        { when: { sensor: "back", is: "<", than: 76 }, do: "stop" },
      ],
    };
    const stop: ChallengeDocument = {
      ...lap,
      mazes: [
        {
          format: "corridor/maze",
          version: 1,
          name: "",
          blocks: ["....", "#.#.", "...."],
          start: { column: 0, row: 0, heading: "east" },
          goals: [],
        },
      ],
      goal: { kind: "stop", sensor: "right", from: 0, to: 101 },
      program: null,
      allowed: {
        drivers: ["program"],
        lines: 2,
        conditions: null,
        actions: ["forward", "stop", "delayed right 90"],
        edits: ["lines"],
        maze: false,
      },
    };
    const [outcome] = checkChallenge(stop, program).mazes;
    expect(outcome?.failure).toBeNull();
    expect(judged(stop, 0, program)).toMatchObject({ kind: "met", tick: outcome?.ticks });
  });

  it("takes a stop only when the robot stays where the sensor says", () => {
    const bench = new Bench(challengeOfMission("how-far"));
    bench.loop.hold("forward");
    while (bench.loop.snapshot().sensors.front > 160) bench.pass(16, 16);
    expect(bench.look()).toEqual({ kind: "open" });
    bench.loop.hold("stop");
    const { tick } = bench.loop.snapshot();
    const met = { kind: "met", driver: "me", tick, bumps: 0 };
    expect(bench.look()).toEqual(met);
    // Later events do not revert it, nor does a later truncation; an earlier truncation and a reset
    // do.
    bench.loop.hold("forward");
    bench.pass(3000);
    bench.loop.seek(tick + 30);
    bench.loop.hold("reverse");
    expect(bench.look()).toEqual(met);
    bench.loop.seek(tick - 30);
    bench.loop.hold("reverse");
    expect(bench.look()).toEqual({ kind: "open" });
    bench.loop.reset();
    expect(bench.look()).toEqual({ kind: "open" });
  });

  it("fails at the first bump too many and stays so until a reset", () => {
    const program = answers["no-room"].wrong.attempt as ProgramDocument;
    const bench = new Bench(challengeOfMission("no-room"), program);
    const failed = bench.runThrough(1);
    expect(failed).toMatchObject({ kind: "failed", code: "bump" });
    bench.loop.run();
    bench.pass(10_000);
    expect(bench.judgement).toEqual(failed);
    bench.loop.reset();
    expect(bench.look()).toEqual({ kind: "open" });
  });

  it("does not count a goal that another driver reached", () => {
    const challenge = challengeOfMission("one-line");
    const bench = new Bench(challenge, answers["one-line"].solution as ProgramDocument);
    bench.loop.hold("forward");
    bench.pass(200);
    bench.loop.hold("stop");
    expect(bench.runThrough(1)).toMatchObject({ kind: "failed", code: "driver" });
  });

  it("reports when the time is over", () => {
    const challenge = challengeOfMission("one-line");
    const { seconds } = challenge.checks;
    const bench = new Bench({ ...challenge, checks: { bumps: null, seconds } });
    expect(bench.runThrough("max")).toEqual({
      kind: "failed",
      code: "late",
      tick: seconds * 60 + 1,
    });
    // The robot waits here, and drives on if the student wants that.
    expect(bench.loop.isRunning).toBe(false);
    expect(bench.loop.snapshot().tick).toBe(seconds * 60 + 1);
    bench.loop.run();
    bench.pass(100);
    expect(bench.loop.isRunning).toBe(true);
  });
});
