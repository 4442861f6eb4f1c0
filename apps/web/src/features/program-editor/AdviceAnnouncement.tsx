/** Announces new advice once to screen readers. Sighted students see it in its line. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useAnnouncement } from "../../model/use-announcement.ts";
import { adviceOn } from "../../model/advice/advice-store.ts";
import { useAdviceText } from "./use-advice-text.ts";

export function AdviceAnnouncement() {
  const { t } = useTranslation();
  const { workspace, advice } = useServices();
  const announcement = useStore(advice, (state) =>
    state.announcement !== null &&
    adviceOn(state.announcement.line, state)?.kind === state.announcement.kind
      ? state.announcement
      : null,
  );
  const line = announcement?.line ?? "default";
  const when = useStore(workspace, ({ program }) =>
    line === "default" ? null : (program.rules[line]?.when ?? null),
  );
  const text = useAdviceText(announcement, when);
  useAnnouncement(
    text === null
      ? null
      : line === "default"
        ? t("program.advice.announcementOtherwise", { advice: text.reason })
        : t("program.advice.announcement", { line: line + 1, advice: text.reason }),
    "advice",
  );
  return null;
}
