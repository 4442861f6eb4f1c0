/** Note on the lower edge of the running line: the progress of its manoeuvre, or its bump. */
import type { LineRef } from "@corridor/protocol";
import { useLayoutEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { Throttle } from "../../ui/throttle.ts";
import { classNames } from "../../ui/class-names.ts";
import { memoize } from "../../ui/memoize.ts";
import { BurstIcon } from "../../ui/BurstIcon.tsx";
import { shownProgress, type ShownBump, type ShownProgress } from "../../model/run/line-state.ts";
import styles from "./line-notes.module.css";

interface LineNoteProps {
  line: LineRef;
  /** null while the robot touches nothing */
  bump: ShownBump | null;
  /** whether the bump stands in the room of the advice, which is hidden at a bump */
  isInside?: boolean;
}

/** Takes no space of its own, so that no line moves when another one drives. */
export function LineNote({ line, bump, isInside = false }: LineNoteProps) {
  return bump === null ? (
    <LineProgress line={line} />
  ) : (
    <div className={classNames(styles["note"], isInside && styles["inside"])}>
      <LineBump bump={bump} />
    </div>
  );
}

/**
 * Sample counts, a small one and the most degrees of a turn. Plural forms depend on the count, and
 * the longest text sets the width.
 */
const COUNTS = [5, 180];

/**
 * A progress bar with text: "turns in 36 cm". It is always rendered, and hidden while the line
 * rests. Moving parts are written directly to their elements.
 */
function LineProgress({ line }: Pick<LineNoteProps, "line">) {
  const { t } = useTranslation();
  const { deferred } = useServices();
  const note = useRef<HTMLDivElement>(null);
  const bar = useRef<HTMLProgressElement>(null);
  const fill = useRef<HTMLSpanElement>(null);
  const text = useRef<HTMLSpanElement>(null);
  // Plural forms depend on the number, and there are only as many numbers as centimetres in a cell.
  const wordsOf = useMemo(() => {
    const of = (kind: ShownProgress["kind"]) =>
      memoize((left: number) => t(`program.progress.${kind}`, { count: left }));
    return { approach: of("approach"), turn: of("turn"), leave: of("leave") };
  }, [t]);
  useLayoutEffect(() => {
    const pace = new Throttle<ShownProgress["kind"] | null>(() => performance.now());
    const [box, progressBar, filled, label] = [
      note.current,
      bar.current,
      fill.current,
      text.current,
    ];
    if (!box || !progressBar || !filled || !label) return undefined;
    const node = new Text();
    label.firstElementChild?.replaceChildren(node);
    let hasRoom = false;
    const makeRoom = (): void => {
      const all = Object.values(wordsOf).flatMap((words) => COUNTS.map((count) => words(count)));
      label.dataset["longest"] = all.join("\n");
      hasRoom = true;
    };
    const look = (state: RunState): void => {
      const progress = shownProgress(line, state);
      const isMoving = state.snapshot?.state === "running";
      const isDue = pace.isDue(isMoving, progress?.kind ?? null);
      const isResting = progress === null;
      // Writing an attribute triggers a style recalculation, even if the value stays the same.
      if (box.hasAttribute("data-resting") !== isResting) {
        box.toggleAttribute("data-resting", isResting);
        progressBar.ariaHidden = String(isResting);
      }
      if (isResting) return;
      if (!hasRoom) makeRoom();
      const { kind, left, of } = progress;
      const words = wordsOf[kind](left);
      filled.style.backgroundSize = `${(100 * (of - left)) / of}%`;
      if (node.data !== words) node.data = words;
      if (!isDue) return;
      progressBar.max = of;
      progressBar.value = of - left;
      progressBar.setAttribute("aria-label", words);
    };
    look(deferred.getState());
    return deferred.subscribe(look);
  }, [deferred, line, wordsOf]);
  return (
    <div ref={note} className={styles["note"]} data-resting="">
      <div className={styles["progress"]}>
        {/* Without a value, Chromium animates it even while it is hidden: eight frames per second. */}
        <progress ref={bar} value={0} aria-hidden="true" />
        <span ref={fill} className={styles["bar"]} aria-hidden="true" />
        <span ref={text} className={styles["words"]} aria-hidden="true">
          <span className="live-box" />
        </span>
      </div>
    </div>
  );
}

/** Example: "bumped after 24 of 50 cm". */
function LineBump({ bump }: { bump: ShownBump }) {
  const { t } = useTranslation();
  const { driven, needed } = bump;
  return (
    <p className={styles["bump"]}>
      <BurstIcon size={16} />
      {driven === null || needed === null
        ? t("program.bumped.now")
        : t("program.bumped.afterOf", { driven, needed })}
    </p>
  );
}
