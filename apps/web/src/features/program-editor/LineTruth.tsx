/**
 * Whether a line's condition is true at the displayed tick: a tick or a cross with both numbers.
 */
import type { Condition } from "@corridor/program";
import { Check, X } from "lucide";
import { useLayoutEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { RunState } from "../../model/run/run-store.ts";
import { localNumber } from "../../text/numbers.ts";
import { Icon } from "../../ui/Icon.tsx";
import { classNames } from "../../ui/class-names.ts";
import { followText, type StateSource } from "../../ui/follow-text.ts";
import { LiveText } from "../../ui/LiveText.tsx";
import type { TruthAt } from "../../model/run/line-state.ts";
import styles from "./line-truth.module.css";

interface LineTruthProps {
  /** run updates for this line */
  feed: StateSource<RunState>;
  /** null: the line does nothing and is skipped */
  condition: Condition | null;
  truth: TruthAt;
  className?: string | undefined;
}

export function LineTruth({ feed, condition, truth, className }: LineTruthProps) {
  const { t, i18n } = useTranslation();
  const { language } = i18n;
  const element = useRef<HTMLSpanElement>(null);
  const { is, word, left, right } = useMemo(() => {
    const yes = t("program.true");
    const no = t("program.false");
    const side =
      (of: "left" | "right") =>
      ({ snapshot }: RunState): string =>
        localNumber(truth(snapshot)?.[of] ?? "", language);
    return {
      is: ({ snapshot }: RunState): string => String(truth(snapshot)?.isTrue),
      word: ({ snapshot }: RunState): string => {
        const isTrue = truth(snapshot)?.isTrue;
        return isTrue === undefined ? "" : isTrue ? yes : no;
      },
      left: side("left"),
      right: side("right"),
    };
  }, [language, t, truth]);
  // The attribute controls the look. Both icons are always rendered, so React does not render
  // again.
  useLayoutEffect(
    () => followText(feed, is, (next) => element.current?.setAttribute("data-is", next)),
    [feed, is],
  );
  if (condition === null) {
    return (
      <span className={styles["truth"]} data-is="skipped">
        <span className={classNames("live-box", styles["sides"])}>{t("program.skipped")}</span>
      </span>
    );
  }
  return (
    <span
      ref={element}
      className={classNames(
        styles["truth"],
        condition.than === "right" && styles["compares"],
        className,
      )}
    >
      <span className={classNames("live-box", styles["sides"])}>
        <span className={styles["mark"]}>
          <Icon of={Check} className={styles["yes"]} size={14} />
          <Icon of={X} className={styles["no"]} size={14} />
          <LiveText
            of={feed}
            text={word}
            className={classNames("visually-hidden", styles["word"])}
          />
          <LiveText of={feed} text={left} className={styles["left"]} />
        </span>{" "}
        <LiveText of={feed} text={right} className={styles["than"]} />
      </span>
    </span>
  );
}
