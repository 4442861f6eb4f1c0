/**
 * Opens the runs of a check. A failed run plays its last seconds, one that passes opens at its start.
 * A given maze opens in its task, an unseen one as a project of its own, with a message that leads
 * back.
 */
import { mazeOf, type LessonTask } from "@corridor/challenge";
import { recordRun } from "../../simulator/record-runs.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import { openTask } from "../challenge/challenge-store.ts";
import type { MazeFailure, MazePass } from "../check/attempt-result.ts";
import { failureStart } from "../check/failure-start.ts";
import { RunOpener } from "../projects/run-opener.ts";
import { loadRun } from "../run/run-requests.ts";
import { watchAgain } from "../run/watch-again.ts";
import { showMessage } from "../screen/screen-store.ts";
import type { LessonsNavigation } from "./lessons-navigation.ts";
import type { LessonsPorts } from "./lessons-ports.ts";

/** A run in an unseen maze. */
interface UnseenRun {
  maze: number;
  ticks: number;
  doesFail: boolean;
}

export class RunWatcher {
  readonly #ports: LessonsPorts;
  readonly #pool: WorkerPool;
  readonly #navigation: Pick<LessonsNavigation, "showMaze">;
  readonly #opener: RunOpener;

  constructor(
    ports: LessonsPorts,
    pool: WorkerPool,
    navigation: Pick<LessonsNavigation, "showMaze">,
  ) {
    this.#ports = ports;
    this.#pool = pool;
    this.#navigation = navigation;
    this.#opener = new RunOpener(ports, pool);
  }

  /**
   * @param name of the maze
   * @param opened says what happens in a maze of its own project
   */
  async watch({ maze, failure }: MazeFailure, name: string, opened: string): Promise<void> {
    const task = openTask(this.#ports.challenge.getState());
    if (task === null || maze === null) return;
    const ticks = failure.tick ?? 0;
    if (maze < task.mazes.length) await this.#watchGiven(task, maze, ticks);
    else await this.#openUnseen(task, { maze, ticks, doesFail: true }, name, opened);
  }

  /** Opens an unseen maze in which the program passes. See `watch`. */
  async open(pass: MazePass, name: string, opened: string): Promise<void> {
    const task = openTask(this.#ports.challenge.getState());
    if (task !== null) await this.#openUnseen(task, { ...pass, doesFail: false }, name, opened);
  }

  async #openUnseen(
    task: LessonTask,
    { maze, ticks, doesFail }: UnseenRun,
    name: string,
    opened: string,
  ): Promise<void> {
    const { workspace, words } = this.#ports;
    const { program } = workspace.getState();
    const run = { maze: { ...mazeOf(task, maze), name }, attempt: program, ticks };
    await this.#opener.open(run, doesFail, {
      opened,
      notOpened: words.t("check:notOpened"),
      back: words.t("missions:lesson.back"),
      stays: true,
    });
  }

  async #watchGiven(task: LessonTask, at: number, ticks: number): Promise<void> {
    const { challenge, workspace, simulator, screen, words } = this.#ports;
    const { program, maze } = workspace.getState();
    const given = { ...mazeOf(task, at), name: maze.name };
    const written = await recordRun(this.#pool, { maze: given, attempt: program, ticks });
    const isSame =
      openTask(challenge.getState()) === task && workspace.getState().program === program;
    if (!isSame) return;
    if (written?.ok !== true) {
      showMessage(screen, { tone: "bad", text: words.t("check:notOpened") });
      return;
    }
    if (challenge.getState().maze !== at) this.#navigation.showMaze(at);
    const loaded = await loadRun(simulator, written.run).loaded;
    if (loaded.ok) watchAgain(simulator, failureStart(ticks));
    else showMessage(screen, { tone: "bad", text: words.t("check:notOpened") });
  }
}
