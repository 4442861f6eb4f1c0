/**
 * Announces new advice once to screen readers. Sighted students see it in its line. Scrolls the
 * line that has the focus into view with its advice.
 */
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { useSay } from "../speech/use-announcement.ts";
import { adviceOn } from "./advice-store.ts";
import { lineElementId } from "./focus-line.ts";
import { useAdviceText } from "./use-advice-text.ts";

export function AdviceNews() {
  const { t } = useTranslation();
  const { workspace, advice } = useServices();
  const news = useStore(advice, (state) =>
    state.news !== null && adviceOn(state.news.line, state)?.kind === state.news.kind
      ? state.news
      : null,
  );
  const line = news?.line ?? "default";
  const when = useStore(workspace, ({ program }) =>
    line === "default" ? null : (program.rules[line]?.when ?? null),
  );
  const text = useAdviceText(news, when);
  useEffect(() => {
    if (news === null || news.line === "default") return undefined;
    const id = workspace.getState().lineIds[news.line];
    const element = document.getElementById(lineElementId(id ?? -1));
    // The note of the first advice may render in the same frame.
    const frame = requestAnimationFrame(() => {
      if (element?.contains(document.activeElement)) element.scrollIntoView({ block: "nearest" });
    });
    return () => cancelAnimationFrame(frame);
  }, [news, workspace]);
  useSay(
    text === null
      ? null
      : line === "default"
        ? t("program.advice.newsOtherwise", { advice: text.reason })
        : t("program.advice.news", { line: line + 1, advice: text.reason }),
    "advice",
  );
  return null;
}
