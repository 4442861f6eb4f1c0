/** Permissions of the open task; null while none is open, which permits everything. */
import type { HelpKind, Rights, ToolName } from "@corridor/challenge";
import { useStore } from "zustand";
import { showsHelp } from "./challenge/challenge-store.ts";
import { useServices } from "./use-services.ts";

export function useRights(): Rights | null {
  const { challenge } = useServices();
  return useStore(challenge, (state) => state.rights);
}

/** Whether the page shows a tool. */
export function useTool(tool: ToolName): boolean {
  return useRights()?.tools.has(tool) !== false;
}

/** Whether the page gives a kind of help. */
export function useHelp(kind: HelpKind): boolean {
  return showsHelp(useRights(), kind);
}
