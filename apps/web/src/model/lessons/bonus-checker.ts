/**
 * Checks the open bonus mission in a worker whenever the program or the maze changes. Stores the best
 * result on the device.
 */
import { startingProgram, type Task } from "@corridor/challenge";
import { createStore } from "zustand/vanilla";
import type { BonusAnswer, BonusAnswers } from "../../simulator/protocol/bonus-request.ts";
import { openTask } from "../challenge/challenge-store.ts";
import { askWorker, type AskBonus } from "./ask-bonus.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import type { LessonsProgress } from "./lessons-progress.ts";
import { BONUS_SECONDS, bonusMissionOf, type BonusMissionId } from "./missions/bonus-missions.ts";

/** Current state of the open bonus mission. */
export type BonusStatus =
  | { kind: "none" }
  | { kind: "checking" }
  | { kind: "failed" }
  | { kind: "mazes"; result: BonusAnswers["mazes"] }
  | { kind: "defeat"; result: BonusAnswers["defeat"] }
  | { kind: "hand"; bumps: number; ticks: number };

/** Edits arrive with each key, so the check waits until they pause. */
const PAUSE_MS = 300;

export class BonusChecker {
  readonly #ports: LessonsPorts;
  readonly #progress: Pick<LessonsProgress, "add">;
  readonly #ask: AskBonus;
  readonly status = createStore<{ status: BonusStatus }>(() => ({ status: { kind: "none" } }));
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** rises with each change; answers to older questions are discarded */
  #asked = 0;

  constructor(
    ports: LessonsPorts,
    progress: Pick<LessonsProgress, "add">,
    ask: AskBonus = askWorker,
  ) {
    this.#ports = ports;
    this.#progress = progress;
    this.#ask = ask;
    ports.challenge.subscribe((next, before) => {
      if (openTask(next) !== openTask(before)) this.#changed();
      else if (next.result !== before.result) this.#followHand();
    });
    ports.simulator.listen((message) => {
      const isGoal = message.type === "event" && message.event.kind === "goal";
      if (!isGoal || ports.challenge.getState().mission !== "beat-right-wall") return;
      // A program that reaches the goal is the student's failure here. No card may call it solved.
      const { tick } = message.event;
      ports.challenge.setState({ result: { state: "failed", code: "not-reached", tick } });
    });
    ports.workspace.subscribe((next, before) => {
      if (next.maze !== before.maze || next.program !== before.program) this.#changed();
    });
  }

  #changed(): void {
    clearTimeout(this.#timer);
    const asked = ++this.#asked;
    const state = this.#ports.challenge.getState();
    const task = openTask(state);
    const bonus = bonusMissionOf(state.mission);
    this.status.setState({ status: { kind: "none" } });
    if (bonus === null || bonus === "fewest-bumps" || task === null) return;
    this.#timer = setTimeout(() => void this.#check(bonus, task, asked), PAUSE_MS);
  }

  async #check(
    bonus: Exclude<BonusMissionId, "fewest-bumps">,
    task: Task,
    asked: number,
  ): Promise<void> {
    const { maze, program } = this.#ports.workspace.getState();
    this.status.setState({ status: { kind: "checking" } });
    let answer: BonusAnswer;
    try {
      answer = await this.#ask(
        bonus === "all-mazes"
          ? { kind: "mazes", task, program }
          : {
              kind: "defeat",
              maze,
              program: startingProgram(task),
              seconds: BONUS_SECONDS,
            },
      );
    } catch {
      if (asked === this.#asked) this.status.setState({ status: { kind: "failed" } });
      return;
    }
    if (asked !== this.#asked || answer.kind === "trail") return;
    if (answer.kind === "mazes") {
      const { solved, all, ticks } = answer.value;
      this.status.setState({ status: { kind: "mazes", result: answer.value } });
      if (solved > 0) this.#store(bonus, [all - solved, ticks]);
      return;
    }
    this.status.setState({ status: { kind: "defeat", result: answer.value } });
    if (answer.value.state === "defeated") this.#store(bonus, [answer.value.squares]);
  }

  /** The challenge judges a drive by hand while it runs. Its end is the result. */
  #followHand(): void {
    const { mission, result } = this.#ports.challenge.getState();
    if (mission !== "fewest-bumps") return;
    if (result.state !== "met") {
      this.status.setState({ status: { kind: "none" } });
      return;
    }
    const { bumps, ticks } = result;
    this.status.setState({ status: { kind: "hand", bumps, ticks } });
    this.#store(mission, [bumps, ticks]);
  }

  #store(bonus: BonusMissionId, result: readonly number[]): void {
    this.#progress.add({ best: { [bonus]: result } });
  }
}
