/** The result of the race in one sentence. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { formatSeconds } from "../../text/numbers.ts";
import { raceResult } from "./race-result.ts";

export function useResultText(): string {
  const { t, i18n } = useTranslation("race", { useSuspense: false });
  const { race } = useServices();
  const result = raceResult(useStore(race));
  if (result.kind === "waiting" || result.kind === "alone") return t(`result.${result.kind}`);
  const { kind, badge, ticks } = result;
  return t(`result.${kind}`, { badge, seconds: gapText(ticks, i18n.language) });
}

/** Shows hundredths for gaps below a tenth of a second, so that no gap reads as zero. */
function gapText(ticks: number, language: string): string {
  return ticks < 6
    ? new Intl.NumberFormat(language, {
        numberingSystem: "latn",
        minimumFractionDigits: 2,
        maximumFractionDigits: 2,
      }).format(ticks / 60)
    : formatSeconds(ticks, language);
}
