/** Names the size and the limit of a lesson that is too large, and the part to shorten. */
import type { LessonPart } from "@corridor/link";
import { useTranslation } from "react-i18next";
import { groupedNumber } from "../../../text/grouped-number.ts";
import { joinSentences } from "../../../text/joined.ts";
import { localNumber } from "../../../text/numbers.ts";
import type { Excess } from "./share-sizes.ts";

const KIB = 1_024;
const MIB = KIB * KIB;

export function useExcessText() {
  const { t, i18n } = useTranslation("lessonEditor", { useSuspense: false });
  const { t: words } = useTranslation();
  /** Rounded up: a size beyond the limit never shows as the limit. */
  const numberIn = {
    link: (characters: number) => groupedNumber(characters, i18n.language),
    shortLink: (bytes: number) => groupedNumber(Math.ceil(bytes / KIB), i18n.language),
    class: (bytes: number) => groupedNumber(Math.ceil(bytes / KIB), i18n.language),
    file: (bytes: number) => localNumber(String(Math.ceil((10 * bytes) / MIB) / 10), i18n.language),
  };
  const remedy = ({ task, part }: LessonPart): string =>
    task === null ? t("share.shorten.lesson") : t(`share.shorten.${part}`, { number: task + 1 });
  return (way: keyof typeof numberIn, { size, limit, longest }: Excess): string => {
    const numbers = { size: numberIn[way](size), limit: numberIn[way](limit) };
    return joinSentences(words, [t(`share.excess.${way}`, numbers), remedy(longest)]);
  };
}
