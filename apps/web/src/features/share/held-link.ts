/**
 * Once something is shared, the address bar holds its link, so that it can be copied from there. It is true
 * for as long as what it carries is as it was: a change takes it out of the address again.
 */
import type { WorkspaceStore } from "../../stores/workspace-store.ts";

/** What a held link carries, as the history entry remembers it: a reload must not open it as another work. */
type Held = "maze" | "program";

/** As much of the browser as the address bar needs. */
export interface LinkBar {
  location: Pick<Location, "pathname" | "search" | "hash">;
  history: Pick<History, "state" | "replaceState">;
}

/** @param text the link without its address: what follows the `#` */
export function holdLink(
  workspace: WorkspaceStore,
  { location, history }: LinkBar,
  text: string,
  held: Held,
): void {
  history.replaceState({ held }, "", `${location.pathname}${location.search}#${text}`);
  letGoWithChange(workspace, { location, history }, held);
}

/** @returns whether the address holds the link of what is open already, as after a reload */
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
    // Another link, or a mission, may be there by now.
    if (location.hash === hash) {
      history.replaceState(null, "", location.pathname + location.search);
    }
  });
}

function heldIn(state: unknown): Held | null {
  if (typeof state !== "object" || state === null || !("held" in state)) return null;
  return state.held === "maze" || state.held === "program" ? state.held : null;
}
