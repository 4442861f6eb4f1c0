/** Why a hand-in is not checked, and how to fix it. */
import type { TFunction } from "i18next";
import type { HandInProblem } from "./hand-in-entries.ts";

export function problemSentence(t: TFunction<"teach">, { code, problems }: HandInProblem): string {
  const sentence = t(`problem.${code}`);
  const [first] = code === "document" ? problems : [];
  if (first === undefined) return sentence;
  const detail = t("problem.detail", { ...first, path: first.path || t("problem.file") });
  return `${sentence} ${detail}`;
}
