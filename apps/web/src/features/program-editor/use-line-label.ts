/**
 * Updates a line's name for screen readers: its condition and action, its state, and its numbers
 * at a throttled rate.
 */
import type { Rule } from "@corridor/program";
import { useLayoutEffect, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import type { RunState } from "../../model/run/run-store.ts";
import { Throttle } from "../../ui/throttle.ts";
import type { StateSource } from "../../ui/follow-text.ts";
import { lineNamer } from "../../model/run/line-name.ts";
import { lineStateOf, type TruthAt } from "../../model/run/line-state.ts";

interface LabelledLine {
  index: number;
  rule: Rule;
  /** the reason of its advice; null if there is none */
  advice: string | null;
  truth: TruthAt;
}

/**
 * Writes the name directly to the element. React would render the line again for each number in it.
 */
export function useLineLabel(
  element: RefObject<HTMLElement | null>,
  feed: StateSource<RunState>,
  { index, rule, advice, truth }: LabelledLine,
): void {
  const { t, i18n } = useTranslation();
  const { language } = i18n;
  useLayoutEffect(() => {
    const nameOf = lineNamer(t, language, { index, rule, advice });
    const pace = new Throttle<string>(() => performance.now());
    let written = "";
    const look = (run: RunState): void => {
      const state = lineStateOf(index, rule, run);
      const shown = truth(run.snapshot);
      const isMoving = run.snapshot?.state === "running";
      if (!pace.isDue(isMoving, `${state} ${shown?.isTrue}`)) return;
      const name = nameOf(state, shown);
      if (name === written) return;
      written = name;
      element.current?.setAttribute("aria-label", name);
    };
    look(feed.getState());
    return feed.subscribe(look);
  }, [element, t, language, feed, index, rule, advice, truth]);
}
