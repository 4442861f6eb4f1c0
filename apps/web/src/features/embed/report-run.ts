/** Reports the runs of the page to the site around it. */
import { lessonMark, type LessonTask } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { openTask, type ChallengeState } from "../../model/challenge/challenge-store.ts";
import type { Services } from "../../model/services.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { type FrameReport, TICKS_PER_SECOND } from "@corridor/protocol";

type Observed = Pick<Services, "run" | "challenge"> & {
  workspace: Pick<Services["workspace"], "getState">;
  simulator: Pick<Services["simulator"], "listen">;
};

/** Decimal places of a time: a tick is 1/60 s. */
const DECIMALS = 2;

export class RunReporter {
  readonly #services: Observed;
  readonly #send: (report: FrameReport) => void;
  #attempts = 0;
  /** whether the next tick is the first of a run */
  #isFresh = true;
  /** the task whose attempts are counted */
  #task: LessonTask | null = null;

  constructor(services: Observed, send: (report: FrameReport) => void) {
    this.#services = services;
    this.#send = send;
    const { run, challenge, simulator } = services;
    run.subscribe(({ nowTick, snapshot }) => {
      if (nowTick === 0 && snapshot?.state !== "running") this.#isFresh = true;
      else this.#begin();
    });
    simulator.listen((message) => {
      if (message.type === "event") this.#event(message.event);
    });
    challenge.subscribe((next, before) => {
      if (openTask(next) !== this.#task) this.restart();
      if (next.result !== before.result) this.#result(next);
    });
  }

  /** Counts the attempts at another task, or in another maze. */
  restart(): void {
    this.#task = openTask(this.#services.challenge.getState());
    this.#attempts = 0;
  }

  #begin(): void {
    if (!this.#isFresh) return;
    this.#isFresh = false;
    this.#attempts++;
    this.#send({ type: "run", attempts: this.#attempts });
  }

  #event({ kind, tick, bumps, line }: RunEvent): void {
    this.#begin();
    const seconds = secondsOf(tick);
    if (kind === "bump") {
      this.#send({
        type: "bump",
        seconds,
        bumps,
        line: typeof line === "number" ? line + 1 : null,
      });
      return;
    }
    // The task of a lesson decides itself when it is met.
    if (this.#services.challenge.getState().lesson !== null) return;
    const { length: lines } = this.#services.workspace.getState().program.rules;
    this.#send({
      type: "met",
      task: 1,
      lines,
      seconds,
      bumps,
      attempts: this.#attempts,
      code: null,
    });
  }

  #result({ lesson, index, result }: ChallengeState): void {
    if (lesson === null || result.state === "open" || result.state === "here") return;
    this.#begin();
    const task = index + 1;
    const attempts = this.#attempts;
    if (result.state === "failed") {
      const { code, tick } = result;
      this.#send({ type: "failed", task, code, seconds: secondsOf(tick), attempts });
      return;
    }
    const { lines, ticks, bumps, driver } = result;
    const { program } = this.#services.workspace.getState();
    const code =
      driver === "program"
        ? encodeLink({ completion: { lesson: lessonMark(lesson), task: index, attempt: program } })
        : null;
    this.#send({
      type: "met",
      task,
      lines,
      seconds: secondsOf(ticks),
      bumps,
      attempts,
      code: code?.ok === true ? code.text : null,
    });
  }
}

function secondsOf(ticks: number): number {
  return Number((ticks / TICKS_PER_SECOND).toFixed(DECIMALS));
}
