import type { Advice } from "@corridor/coach";
import type { Condition } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import type { AdviceText } from "../../model/advice/advice-text.ts";

/**
 * An advice in words; null if there is none, or while the coach is not loaded.
 * @param when the condition of the line that the advice is about; null for "otherwise"
 */
export function useAdviceText(given: Advice | null, when: Condition | null): AdviceText | null {
  const { t, i18n } = useTranslation();
  const { advice } = useServices();
  return given && advice.textOf(t, i18n.language, given, when);
}
