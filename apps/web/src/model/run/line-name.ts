/**
 * A line's name for screen readers: its sentence, whether it runs, and its truth with the numbers.
 */
import type { Rule } from "@corridor/program";
import type { TFunction } from "i18next";
import { joinSentences } from "../../text/joined.ts";
import { localNumber } from "../../text/numbers.ts";
import { preparePhrase } from "../../text/phrase.ts";
import type { LineState, ShownTruth } from "./line-state.ts";

export interface LineNameParts {
  index: number;
  rule: Rule;
  state: LineState;
  truth: ShownTruth | null;
  /** the reason of its advice as a whole sentence; null if there is none */
  advice: string | null;
}

/** Example: "Line 1, running: if right is more than 60, delayed right 90. Right is 250, true." */
export function lineName(
  t: TFunction,
  { index, rule, state, truth, advice }: LineNameParts,
): string {
  const { when } = rule;
  const head = t(`program.name.${state === "notRead" ? "resting" : state}`, { line: index + 1 });
  const sentences = [];
  if (when === null) sentences.push(t("program.name.nothing"));
  else {
    const action = t(`program.action.${rule.do}`);
    const sensor = t(`program.sensor.${when.sensor}`);
    const isMore = when.is === ">";
    sentences.push(
      when.than === "right"
        ? t(isMore ? "program.name.moreThanRight" : "program.name.lessThanRight", {
            sensor,
            number: when.plus,
            action,
          })
        : t(isMore ? "program.name.more" : "program.name.less", {
            sensor,
            number: when.than,
            action,
          }),
    );
    if (truth !== null) {
      const fact = {
        sensor: t(`program.sensorFirst.${when.sensor}`),
        number: truth.left,
      };
      sentences.push(
        state === "notRead"
          ? t(truth.isTrue ? "program.name.isTrueNotRead" : "program.name.isFalseNotRead", fact)
          : t(truth.isTrue ? "program.name.isTrue" : "program.name.isFalse", fact),
      );
    }
  }
  if (advice !== null) sentences.push(t("program.name.advice", { advice }));
  return joinSentences(t, [head, ...sentences]);
}

/**
 * Builds names for a line whose state and truth change often. It translates each sentence once.
 */
export function lineNamer(
  t: TFunction,
  language: string,
  line: Pick<LineNameParts, "index" | "rule" | "advice">,
): (state: LineState, truth: ShownTruth | null) => string {
  const prepared = new Map<string, (values: { left: string }) => string>();
  return (state, truth) => {
    const key = `${state} ${truth?.isTrue}`;
    let phrase = prepared.get(key);
    if (phrase === undefined) {
      phrase = preparePhrase(["left"], ({ left }) =>
        lineName(t, { ...line, state, truth: truth === null ? null : { ...truth, left } }),
      );
      prepared.set(key, phrase);
    }
    return phrase({ left: truth === null ? "" : localNumber(truth.left, language) });
  };
}
