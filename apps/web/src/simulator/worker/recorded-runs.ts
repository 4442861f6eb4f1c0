/**
 * Recorded runs: opens one in place of the live run, restores the one from before a reload, and
 * saves the live one. The code that replays them loads with the first of them.
 */
import type { RunDocument } from "@corridor/recording";
import type {
  FromWorker,
  LoadedRun,
  LoadRun,
  RestoreRun,
  SavedRun,
} from "../protocol/worker-messages.ts";
import { afterMessages } from "./after-messages.ts";
import { Lazy } from "./lazy.ts";
import type { OpenRecording, RunLoader } from "./run-loader.ts";
import type { RunLoop } from "./run-loop.ts";
import type { StoredWorld } from "./stored-world.ts";

export interface RecordedRunsPorts {
  /** @throws before the documents have arrived */
  run: () => RunLoop;
  world: StoredWorld;
  post: (message: FromWorker) => void;
  /** calls a function and handles its errors */
  guarded: (work: () => void) => void;
  /** a slice of a run was replayed, and the run may be open now */
  onSlice: () => void;
  /** monotonic milliseconds */
  now: () => number;
}

export class RecordedRuns {
  readonly #ports: RecordedRunsPorts;
  readonly #loader: Lazy<RunLoader>;

  constructor(ports: RecordedRunsPorts) {
    this.#ports = ports;
    const { post, guarded, onSlice, now } = ports;
    this.#loader = new Lazy(async () => {
      const { RunLoader: Loader } = await import("./run-loader.ts");
      const loader: RunLoader = new Loader({
        now,
        later: afterMessages(() =>
          guarded(() => {
            loader.next();
            onSlice();
          }),
        ),
        onPart: (id, part) => post({ type: "run-loading", id, part }),
        answer: (id, loaded) => this.#answer(id, loaded),
      });
      return loader;
    }, guarded);
  }

  /** Opens a run; answered by `run-loaded`. */
  open({ id, run }: LoadRun): void {
    this.#load(id, run, (recording) => this.#ports.run().open(recording));
  }

  /** Restores the run from before the reload; answered by `run-loaded`. */
  restore(message: RestoreRun): void {
    const { id } = message;
    this.#ports.world
      .restore(message, {
        load: (run, open) => this.#load(id, run, open),
        answer: (loaded) => this.#answer(id, loaded),
      })
      .catch(() => this.#fail(id));
  }

  /**
   * Cancels the run that is being opened.
   * @param id only this request; without it, any
   */
  cancel(id?: number): void {
    if (this.#loader.isRequested) this.#loader.use((loader) => loader.cancel(id));
  }

  /** Saves the live run; answered by `run-saved`. */
  save(id: number): void {
    const written = this.#ports.run().saveRun();
    const saved: SavedRun = written.ok
      ? { ok: true, text: written.text, ticks: written.run.ticks }
      : written;
    this.#ports.post({ type: "run-saved", id, saved });
  }

  #load(id: number, run: RunDocument, open: OpenRecording): void {
    this.#loader.use(
      (loader) => loader.load({ id, run }, open),
      () => this.#fail(id),
    );
  }

  #fail(id: number): void {
    this.#answer(id, { ok: false, reason: "fault" });
  }

  #answer(id: number, loaded: LoadedRun): void {
    this.#ports.world.claimed();
    this.#ports.post({ type: "run-loaded", id, loaded });
  }
}
