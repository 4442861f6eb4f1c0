/** The work of a first visit, with its names in the reader's language. */
import type { i18n } from "i18next";
import { firstWork as work, type FirstWork } from "../worker/first-work.ts";

export function firstWork(words: Pick<i18n, "t">): FirstWork {
  return work(words.t("presets.long-way-round.title"), words.t("program.example"));
}
