/** Results of the missions and bonus missions on this device, as the page displays them. */
import { createStore } from "zustand/vanilla";
import { dismiss, showMessage } from "../screen/screen-store.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import type { LessonsRecord } from "./lessons-storage.ts";
import { reportUnlessStored } from "./report-unless-stored.ts";

export type Results = Pick<LessonsRecord, "done" | "best">;

export class LessonsProgress {
  readonly #ports: Pick<LessonsPorts, "storage" | "screen" | "words">;
  /** changes with every result */
  readonly results = createStore<Results>(() => ({ done: {}, best: {} }));

  constructor(ports: Pick<LessonsPorts, "storage" | "screen" | "words">) {
    this.#ports = ports;
    this.refresh();
  }

  /** Reads the progress, which another tab may have changed. */
  refresh(): void {
    const { done, best } = this.#ports.storage.record;
    this.results.setState({ done, best });
  }

  /** Stores results. The better of two results stays. */
  add(results: Partial<Results>): void {
    reportUnlessStored(this.#ports, this.#ports.storage.add(results));
    this.refresh();
  }

  /** Deletes the progress. The message offers undo, and attempts stay on the device. */
  delete(): void {
    const { storage, screen, words } = this.#ports;
    const { done, best } = storage.record;
    reportUnlessStored(this.#ports, storage.deleteProgress());
    this.refresh();
    const id = showMessage(screen, {
      tone: "info",
      text: words.t("missions:path.resetDone"),
      action: {
        label: words.t("missions:path.undo"),
        run: () => {
          dismiss(screen, id);
          this.add({ done, best });
        },
      },
    });
  }
}
