/**
 * After sharing, the address bar holds the link, so that students can copy it from there. Any
 * change of the shared content removes the link from the address.
 */
import type { WorkspaceStore } from "../../model/workspace/workspace-store.ts";

/**
 * The content of a held link, stored in the history entry. A reload must not open it as another
 * project.
 */
type Held = "maze" | "program";

/** The part of the browser that the address bar uses. */
export interface LinkBar {
  location: Pick<Location, "pathname" | "search" | "hash">;
  history: Pick<History, "state" | "replaceState">;
}

/** @param text the link without its address: the part after the `#` */
export function holdLink(
  workspace: WorkspaceStore,
  { location, history }: LinkBar,
  text: string,
  held: Held,
): void {
  history.replaceState(
    { ...entryOf(history), held },
    "",
    `${location.pathname}${location.search}#${text}`,
  );
  letGoWithChange(workspace, { location, history }, held);
}

/** @returns whether the address holds the link of the open content, as after a reload */
export function holdAgain(workspace: WorkspaceStore, bar: LinkBar): boolean {
  const held = heldIn(bar.history.state);
  if (held === null || bar.location.hash === "") return false;
  letGoWithChange(workspace, bar, held);
  return true;
}

function letGoWithChange(
  workspace: WorkspaceStore,
  { location, history }: LinkBar,
  held: Held,
): void {
  const { hash } = location;
  const end = workspace.subscribe((next, before) => {
    const isSame =
      next.maze === before.maze && (held === "maze" || next.program === before.program);
    if (isSame) return;
    end();
    // The address may contain another link or a mission by then.
    if (location.hash === hash) {
      const { held: _held, ...entry } = entryOf(history);
      history.replaceState(entry, "", location.pathname + location.search);
    }
  });
}

/** The state of the history entry, which may also name a task. */
function entryOf({ state }: LinkBar["history"]): Record<string, unknown> {
  return typeof state === "object" && state !== null ? { ...state } : {};
}

function heldIn(state: unknown): Held | null {
  if (typeof state !== "object" || state === null || !("held" in state)) return null;
  return state.held === "maze" || state.held === "program" ? state.held : null;
}
