/** The project of a first visit, with translated names. */
import type { i18n } from "i18next";
import {
  firstProject as projectNamed,
  type FirstProject,
} from "../../simulator/protocol/first-project.ts";

export function firstProject(words: Pick<i18n, "t">): FirstProject {
  return projectNamed(words.t("presets.long-way-round.title"), words.t("program.example"));
}
