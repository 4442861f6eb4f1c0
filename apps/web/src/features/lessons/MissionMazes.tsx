/** The mazes of a mission: which one is displayed and which pass and fail in the
 * newest check, or were driven through. */
import { Check, X } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { openTask } from "../../model/challenge/challenge-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import styles from "./mission-mazes.module.css";

export function MissionMazes({ service }: { service: LessonsService }) {
  const { t } = useTranslation("missions", { useSuspense: false });
  const { challenge: store } = useServices();
  const count = useStore(store, (state) => openTask(state)?.mazes.length ?? 0);
  const shown = useStore(store, (state) => state.maze);
  const verdict = useStore(store, (state) => state.checked);
  const outcomes = verdict?.mazes ?? [];
  const driven = useStore(store, (state) => state.drivenMazes);
  // A bonus mission is checked automatically, without a verdict.
  const live = useStore(service.bonus.status, ({ status }) =>
    status.kind === "mazes" ? status.result.failed : null,
  );
  return (
    <ul className={styles["mazeList"]} aria-label={t("card.mazes")}>
      {Array.from({ length: count }, (_, at) => {
        const outcome = outcomes[at];
        const isDriven = verdict === null && driven.includes(at);
        const isKnown = live !== null || outcome !== undefined || isDriven;
        const doesFail = live?.includes(at) ?? (!isDriven && outcome?.failure !== null);
        const state = isKnown ? (doesFail ? "fails" : "passes") : null;
        return (
          <li key={at}>
            <button
              type="button"
              className={styles["maze"]}
              data-state={state ?? undefined}
              aria-pressed={at === shown}
              onClick={() => service.navigation.showMaze(at)}
            >
              {state === "passes" && <Icon of={Check} size={14} />}
              {state === "fails" && <Icon of={X} size={14} />}
              <span aria-hidden={state === null ? undefined : "true"}>
                {t("card.maze", { number: at + 1 })}
              </span>
              {state !== null && (
                <span className="visually-hidden">
                  {t(state === "passes" ? "card.mazePasses" : "card.mazeFails", {
                    number: at + 1,
                  })}
                </span>
              )}
            </button>
          </li>
        );
      })}
    </ul>
  );
}
