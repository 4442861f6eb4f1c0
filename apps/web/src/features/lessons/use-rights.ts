/** What the open challenge leaves to the editor; null while none is open: then everything. */
import type { Rights } from "@corridor/challenge";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";

export function useRights(): Rights | null {
  const { challenge } = useServices();
  return useStore(challenge, (state) => state.rights);
}
