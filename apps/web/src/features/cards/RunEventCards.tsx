/** The place of the cards on the stage, which it renders once there is a card. */
import type { ReactNode } from "react";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";

export function RunEventCards({ children }: { children: ReactNode }) {
  const { cards, challenge } = useServices();
  const isAny = useStore(cards, ({ bump, goal }) => bump !== null || goal !== null);
  const isMet = useStore(challenge, ({ result }) => result.state === "met");
  return isAny || isMet ? children : null;
}
