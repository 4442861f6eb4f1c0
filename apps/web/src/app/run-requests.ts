/**
 * What the page asks the worker about whole runs, each with an answer of its own: several may ask at the
 * same time, and nobody waits for a worker that is gone.
 */
import type { RunDocument } from "@corridor/recording";
import type { SimulatorClient } from "../worker/simulator-client.ts";
import type { LoadedRun, LoadRun, RestoreRun, SavedRun } from "../worker/worker-messages.ts";

type Simulator = Pick<SimulatorClient, "send" | "listen" | "isGone">;

/** A run on its way to the screen. */
export interface RunLoad {
  /** what came of it; never rejected */
  loaded: Promise<LoadedRun>;
  /** gives it up: it is answered as cancelled, unless it is there already */
  cancel: () => void;
}

let lastId = 0;

/**
 * Opens a run where it ended.
 * @param onPart told now and then how much of a long one is done, from 0 to 1
 */
export function loadRun(
  simulator: Simulator,
  run: RunDocument,
  { onPart }: { onPart?: (part: number) => void } = {},
): RunLoad {
  return request(simulator, (id) => ({ type: "load-run", id, run }), onPart);
}

/** Restores the run that this tab had before a reload: see `RestoreRun`. */
export function restoreRun(simulator: Simulator, key: string, isSameProject: boolean): RunLoad {
  return request(simulator, (id) => ({ type: "restore-run", id, key, isSameProject }));
}

function request(
  simulator: Simulator,
  messageOf: (id: number) => LoadRun | RestoreRun,
  onPart?: (part: number) => void,
): RunLoad {
  const id = ++lastId;
  const cancel = () => simulator.send({ type: "cancel-load", id });
  const loaded = new Promise<LoadedRun>((resolve) => {
    if (simulator.isGone) return resolve({ ok: false, reason: "fault" });
    const end = simulator.listen((message) => {
      if (message.type === "run-loading" && message.id === id) onPart?.(message.part);
      const isAnswer = message.type === "run-loaded" && message.id === id;
      if (!isAnswer && message.type !== "fault") return;
      end();
      // What broke may go on: then it must not open a run that nobody waits for any more.
      if (!isAnswer) cancel();
      resolve(isAnswer ? message.loaded : { ok: false, reason: "fault" });
    });
    simulator.send(messageOf(id));
  });
  return { loaded, cancel };
}

/**
 * Asks for the run so far as the text of a document.
 * @param take called once, unless the worker breaks
 * @returns a function that ends the waiting
 */
export function saveRun(simulator: Simulator, take: (saved: SavedRun) => void): () => void {
  const id = ++lastId;
  const end = simulator.listen((message) => {
    if (message.type !== "run-saved" || message.id !== id) return;
    end();
    take(message.saved);
  });
  simulator.send({ type: "save-run", id });
  return end;
}
