/**
 * Evaluates the run: the judge of the open challenge, and the diagnostics of failures. Each loads
 * when it is needed.
 */
import type { FromWorker, ToWorker } from "../protocol/worker-messages.ts";
import { Lazy } from "./lazy.ts";
import type { Diagnostics } from "./run-diagnosis.ts";
import type { RunJudge } from "./run-judge.ts";
import type { RunUpdates } from "./run-updates.ts";

type JudgeMessage = Extract<ToWorker, { type: "judge" }>;
type Attempt = NonNullable<JudgeMessage["attempt"]>;

export interface RunEvaluationPorts {
  post: (message: FromWorker) => void;
  /** calls a function and handles its errors */
  guarded: (work: () => void) => void;
  /** calls a function after a while */
  later: (work: () => void) => void;
  /** the diagnostics have loaded, or did not: updates of the run are due */
  onDiagnostics: () => void;
}

export class RunEvaluation {
  readonly #ports: RunEvaluationPorts;
  readonly #judge: Lazy<typeof RunJudge>;
  readonly #diagnostics: Lazy<Diagnostics>;
  /** id of the newest `judge` message */
  #judgeId = 0;

  constructor(ports: RunEvaluationPorts) {
    this.#ports = ports;
    const { guarded } = ports;
    this.#judge = new Lazy(async () => (await import("./run-judge.ts")).RunJudge, guarded);
    this.#diagnostics = new Lazy(() => import("./diagnose-run.ts"), guarded);
  }

  /**
   * Judges the run by a task. Ticks that run before the judge has loaded are judged then; without a
   * network it is loaded again and again.
   */
  judge(updates: RunUpdates, { id, attempt }: JudgeMessage): void {
    this.#judgeId = id;
    updates.judgeBy(null);
    if (attempt !== null) this.#loadJudge(updates, id, attempt);
  }

  #loadJudge(updates: RunUpdates, id: number, attempt: Attempt): void {
    this.#judge.use(
      (Judge) => {
        if (id === this.#judgeId) updates.judgeBy(new Judge(attempt.task, attempt.maze));
      },
      () =>
        this.#ports.later(() => {
          if (id === this.#judgeId) this.#loadJudge(updates, id, attempt);
        }),
    );
  }

  /** Loads the diagnostics; without them the run continues unexplained. */
  loadDiagnostics(updates: RunUpdates): void {
    if (this.#diagnostics.isRequested) return;
    updates.awaitDiagnostics(true);
    this.#diagnostics.use(
      (diagnostics) => {
        updates.useDiagnostics(diagnostics);
        this.#ports.onDiagnostics();
      },
      () => {
        updates.awaitDiagnostics(false);
        this.#ports.onDiagnostics();
      },
    );
  }

  /** Posts a new diagnosis and a changed judgement. */
  post(updates: RunUpdates): void {
    const { post } = this.#ports;
    const diagnosed = updates.takeDiagnosed();
    if (diagnosed !== null) post({ type: "diagnosed", ...diagnosed });
    const judgement = updates.takeJudgement();
    if (judgement !== null) post({ type: "judgement", id: this.#judgeId, judgement });
  }
}
