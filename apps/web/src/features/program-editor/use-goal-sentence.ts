/** The goal sentence of the open maze, outside of challenges. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";

export function useGoalSentence(): string {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const hasGoal = useStore(workspace, ({ maze }) => maze.goals.length > 0);
  return t(hasGoal ? "program.goal" : "program.noGoal");
}
