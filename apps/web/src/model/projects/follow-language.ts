/** Renames a preset program when the student changes the language. */
import type { i18n } from "i18next";
import type { RunStore } from "../run/run-store.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import { readyMadeName } from "../workspace/own-program.ts";

interface Followers {
  workspace: WorkspaceStore;
  run: RunStore;
}

/**
 * The new name adds no step to the history. During a run the old name stays, because the run would
 * record the edit.
 */
export function followLanguage({ workspace, run }: Followers, words: Pick<i18n, "t" | "on">): void {
  words.on("languageChanged", () => {
    const { program } = workspace.getState();
    const name = readyMadeName(program, words);
    if (name === null || name === program.name || run.getState().nowTick > 0) return;
    const history = workspace.temporal.getState();
    history.pause();
    workspace.setState({ program: { ...program, name } });
    history.resume();
  });
}
