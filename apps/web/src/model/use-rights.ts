/** Permissions of the open challenge; null while none is open, which permits everything. */
import type { Rights } from "@corridor/challenge";
import { useStore } from "zustand";
import { useServices } from "./use-services.ts";

export function useRights(): Rights | null {
  const { challenge } = useServices();
  return useStore(challenge, (state) => state.rights);
}
