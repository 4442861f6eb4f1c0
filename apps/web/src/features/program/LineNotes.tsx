/** What stands under a line while it is at work: how far its manoeuvre is, or the bump it came to. */
import type { LineRef } from "@corridor/protocol";
import { useLayoutEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { RunState } from "../../stores/run-store.ts";
import { CalmPace } from "../../ui/calm-pace.ts";
import { LiveText } from "../../ui/LiveText.tsx";
import { remember } from "../../ui/remember.ts";
import { BurstIcon } from "../timeline/BurstIcon.tsx";
import { shownProgress, type ShownBump, type ShownProgress } from "./line-state.ts";
import styles from "./line-notes.module.css";

interface LineNoteProps {
  line: LineRef;
  /** null while it touches nothing */
  bump: ShownBump | null;
  className?: string | undefined;
}

/** Nothing while the line rests. */
export function LineNote({ line, bump, className }: LineNoteProps) {
  const { run } = useServices();
  const kind = useStore(run, (state) => shownProgress(line, state)?.kind ?? null);
  if (bump === null && kind === null) return null;
  return (
    <div className={className}>
      {bump !== null ? (
        <LineBump bump={bump} />
      ) : (
        kind !== null && <LineProgress line={line} kind={kind} />
      )}
    </div>
  );
}

interface LineProgressProps {
  line: LineRef;
  kind: ShownProgress["kind"];
}

/** A bar that fills and the words to it: "turns in 36 cm". */
function LineProgress({ line, kind }: LineProgressProps) {
  const { t } = useTranslation();
  const { run } = useServices();
  const whole = useStore(run, (state) => shownProgress(line, state)?.of ?? 0);
  const bar = useRef<HTMLProgressElement>(null);
  const fill = useRef<HTMLSpanElement>(null);
  // Words bend with their number, and there are no more numbers than centimetres of a square.
  const words = useMemo(
    () => remember((left: number) => t(`program.progress.${kind}`, { count: left })),
    [t, kind],
  );
  const text = useMemo(
    () =>
      (state: RunState): string => {
        const progress = shownProgress(line, state);
        return progress === null ? "" : words(progress.left);
      },
    [line, words],
  );
  useLayoutEffect(() => {
    const pace = new CalmPace<null>(() => performance.now());
    const look = (state: RunState): void => {
      const progress = shownProgress(line, state);
      if (progress === null || bar.current === null || fill.current === null) return;
      const { left, of } = progress;
      fill.current.style.transform = `scaleX(${(of - left) / of})`;
      if (!pace.isDue(state.snapshot?.state === "running", null)) return;
      bar.current.max = of;
      bar.current.value = of - left;
      bar.current.setAttribute("aria-label", words(left));
    };
    look(run.getState());
    return run.subscribe(look);
  }, [run, line, words]);
  return (
    <div className={styles["progress"]}>
      <progress ref={bar} />
      <span className={styles["bar"]} aria-hidden="true">
        <span ref={fill} />
      </span>
      <span className={styles["words"]} data-widest={words(whole)} aria-hidden="true">
        <LiveText of={run} text={text} />
      </span>
    </div>
  );
}

/** "bumped after 24 of 50 cm" */
function LineBump({ bump }: { bump: ShownBump }) {
  const { t } = useTranslation();
  const { driven, needed } = bump;
  return (
    <p className={styles["bump"]}>
      <BurstIcon size={16} />
      {driven === null
        ? t("program.bumped.now")
        : needed === null
          ? t("program.bumped.after", { driven })
          : t("program.bumped.afterOf", { driven, needed })}
    </p>
  );
}
