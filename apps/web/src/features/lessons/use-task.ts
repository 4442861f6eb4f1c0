/**
 * The sentence of the open task. With a keyboard, the task names its keys, as the labels on the
 * drive keys do. A mission may have a second task with the context "keyboard" for that.
 */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { openTask } from "../../model/challenge/challenge-store.ts";
import { missionIds } from "../../model/lessons/missions/mission.ts";
import { bonusMissionOf } from "../../model/lessons/missions/bonus-missions.ts";

export function useTask(): string {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store } = useServices();
  const open = useStore(store, openTask);
  const id = useStore(store, ({ mission }) => missionIds.find((each) => each === mission));
  const hasKeyboard = useMediaQuery("(hover: hover) and (pointer: fine)");
  const bonus = useStore(store, ({ mission }) => bonusMissionOf(mission));
  if (bonus !== null) return t(`missions:bonusMissions.${bonus}.task`);
  if (id === undefined) return open?.words.task ?? "";
  return t(`missions:missions.${id}.task`, hasKeyboard ? { context: "keyboard" } : {});
}
