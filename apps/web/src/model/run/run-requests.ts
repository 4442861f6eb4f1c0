/**
 * Requests to the worker about whole runs, each with its own answer: several may be pending at the
 * same time, and all fail if the worker is gone.
 */
import type { RunDocument } from "@corridor/recording";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type {
  LoadedRun,
  LoadRun,
  RestoreRun,
  SavedRun,
} from "../../simulator/protocol/worker-messages.ts";

type Simulator = Pick<SimulatorClient, "send" | "listen" | "isGone">;

/** A run that is loading. */
export interface RunLoad {
  /** the result; never rejects */
  loaded: Promise<LoadedRun>;
  /** cancels the request, which fails as cancelled unless it is complete */
  cancel: () => void;
}

let lastId = 0;

/**
 * Opens a run where it ended.
 * @param onPart receives the progress of a long run from time to time, from 0 to 1
 */
export function loadRun(
  simulator: Simulator,
  run: RunDocument,
  { onPart }: { onPart?: (part: number) => void } = {},
): RunLoad {
  return request(simulator, (id) => ({ type: "load-run", id, run }), onPart);
}

/** Restores this tab's run from before a reload: see `RestoreRun`. */
export function restoreRun(
  simulator: Simulator,
  which: Pick<RestoreRun, "key" | "isSameProject" | "atStartSince">,
): RunLoad {
  return request(simulator, (id) => ({ type: "restore-run", id, ...which }));
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
      // The simulator may still recover: then it must not open a run that nobody waits for.
      if (!isAnswer) cancel();
      resolve(isAnswer ? message.loaded : { ok: false, reason: "fault" });
    });
    simulator.send(messageOf(id));
  });
  return { loaded, cancel };
}

/**
 * Requests the run so far as the text of a document.
 * @param take called once, unless the worker breaks
 * @returns a function that cancels the request
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
