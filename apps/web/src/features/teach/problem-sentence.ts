/** Why a hand-in is not checked, and how to fix it. */
import type { TFunction } from "i18next";
import type { HandInProblem } from "./hand-in-entries.ts";

/** @param lessonNames of other lessons, by their marks */
export function problemSentence(
  t: TFunction<"teach">,
  { code, problems }: HandInProblem,
  lessonNames: ReadonlyMap<string, string>,
): string {
  const name = code === "other-lesson" && lessonNames.get(problems[0]?.found ?? "");
  if (typeof name === "string") return t("problem.named-lesson", { name });
  const sentence = t(`problem.${code}`);
  const [first] = code === "document" ? problems : [];
  if (first === undefined) return sentence;
  const detail = t("problem.detail", { ...first, path: first.path || t("problem.file") });
  return `${sentence} ${detail}`;
}
