/** Starts the trials when the button is pressed, and retains the workers for the next press. */
import type { Services } from "../../model/services.ts";
import { trialChoice, type Trials } from "./trials.ts";

/** Time in ms after which idle workers end. */
const IDLE_MS = 60_000;

/**
 * Tries the program when the dialog opens, and when other mazes are chosen in it.
 * @returns a function that stops this, and terminates the workers
 */
export function tryWhileOpen(
  { screen, workspace }: Pick<Services, "screen" | "workspace">,
  trials: Trials,
): () => void {
  const isOpen = () => screen.getState().isTryingMazes;
  let closing: ReturnType<typeof setTimeout> | undefined;
  const begin = () => {
    clearTimeout(closing);
    trials.start(trialChoice.getState(), workspace.getState().program);
  };
  const end = () => {
    trials.clear();
    closing = setTimeout(() => trials.close(), IDLE_MS);
  };
  if (isOpen()) begin();
  const endings = [
    screen.subscribe((now, before) => {
      if (now.isTryingMazes !== before.isTryingMazes) (now.isTryingMazes ? begin : end)();
    }),
    trialChoice.subscribe(() => isOpen() && begin()),
  ];
  return () => {
    for (const stop of endings) stop();
    clearTimeout(closing);
    trials.clear();
    trials.close();
  };
}
