/** One line of the program as a sentence: if …, then …, and whether it is true now. */
import type { Rule } from "@corridor/program";
import { MAX_RULES, setAction } from "@corridor/program";
import { memo, useLayoutEffect, useMemo, useRef } from "react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useShallow } from "zustand/react/shallow";
import { useHelp } from "../../model/use-rights.ts";
import { useServices } from "../../model/use-services.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { Badge } from "../../ui/Badge.tsx";
import { classNames } from "../../ui/class-names.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { ActionMenu } from "./ActionMenu.tsx";
import { adviceOn } from "../../model/advice/advice-store.ts";
import { LazyAdviceNote } from "./lazy-advice.ts";
import { ConditionMenu, ConditionNumber } from "./ConditionField.tsx";
import { lineFeed } from "./line-feed.ts";
import frame from "./line-frame.module.css";
import { LineNote } from "./LineNotes.tsx";
import { shownBump, truthAt } from "../../model/run/line-state.ts";
import { dismissOnce } from "../../model/workspace/dismiss-once.ts";
import { lineElementId } from "../../model/workspace/focus-line.ts";
import { LineTools } from "./LineTools.tsx";
import { LineTruth } from "./LineTruth.tsx";
import {
  applyEdit,
  deleteLine,
  moveLine,
  type RememberedNumbers,
} from "../../model/workspace/program-actions.ts";
import styles from "./program-line.module.css";
import { setFixedProgram } from "../../model/workspace/set-fixed-program.ts";
import { useAdviceText } from "./use-advice-text.ts";
import { useLineLabel } from "./use-line-label.ts";

interface ProgramLineProps {
  id: number;
  index: number;
  count: number;
  rule: Rule;
  remembered: RememberedNumbers;
}

/**
 * Memoized, because a program may have 200 lines. Each renders only when something that it displays
 * changes.
 */
export const ProgramLine = memo(function ProgramLine(props: ProgramLineProps) {
  "use memo";
  const { id, index, count, rule, remembered } = props;
  const { t } = useTranslation();
  const { workspace, screen, run, advice, challenge } = useServices();
  const hasTruth = useHelp("truth");
  const hasFixes = useHelp("fixes");
  const element = useRef<HTMLLIElement>(null);
  const truth = useMemo(() => truthAt(hasTruth ? rule.when : null), [hasTruth, rule.when]);
  const feed = useMemo(() => lineFeed(run, id), [run, id]);
  useLayoutEffect(() => {
    const line = element.current;
    return line === null ? undefined : feed.observe(line);
  }, [feed]);
  const bump = useStore(
    run,
    useShallow((state) => shownBump(index, rule, state)),
  );
  const given = useStore(advice, (state) => adviceOn(index, state));
  const adviceText = useAdviceText(given, rule.when);
  const by = given?.fix ?? null;
  const isBumped = bump !== null;
  useLineLabel(element, feed, { index, rule, advice: adviceText?.reason ?? null, truth });
  const line = index + 1;

  function move(by: -1 | 1) {
    if (challenge.getState().rights?.edits.has("order") === false) return;
    // Moving the element removes its focus. `focusAgain` restores it as soon as the line has its
    // new position.
    const focused = document.activeElement;
    flushSync(() => moveLine(workspace, index, by));
    focusAgain(id, focused, by);
  }

  function remove() {
    if (challenge.getState().rights?.edits.has("lines") === false) return;
    const bringBack = deleteLine(workspace, index);
    const message = showMessage(screen, {
      tone: "info",
      isOfProject: true,
      text: t("program.deleted", { line }),
      action: {
        label: t("program.undo"),
        run: () => {
          const max = challenge.getState().rights?.maxLines ?? MAX_RULES;
          if (bringBack(max)) return;
          showMessage(screen, { tone: "bad", text: t("program.full", { max }) });
        },
      },
    });
    dismissOnce({ screen, workspace }, message, ({ lineIds }) => lineIds.includes(id));
    focusNeighbour(workspace.getState().lineIds, index);
  }

  function fix() {
    const fixed = by && advice.fixedProgram(by);
    if (by === null || fixed === null) return;
    if (by.kind === "delete") {
      remove();
      return;
    }
    flushSync(() => setFixedProgram(workspace, by, fixed));
    // The button disappears with its advice, so the focus moves to the line with the new condition
    // and action.
    document.getElementById(lineElementId(id))?.focus();
  }

  function hide() {
    if (given === null) return;
    flushSync(() => advice.hide(given));
    document.getElementById(lineElementId(id))?.focus();
  }

  function onKeyDown(event: React.KeyboardEvent) {
    // Alt+Down on a menu opens the menu, as elsewhere.
    const isMenu = event.target instanceof HTMLSelectElement;
    const isArrow = event.key === "ArrowUp" || event.key === "ArrowDown";
    if (event.altKey && isArrow && !isMenu) {
      event.preventDefault();
      move(event.key === "ArrowUp" ? -1 : 1);
    } else if (event.key === "Delete" && event.target === event.currentTarget) {
      event.preventDefault();
      remove();
    }
  }

  // A line is a Tab stop itself, so that keys can move and delete the line with the focus.
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions
    <li
      ref={element}
      id={lineElementId(id)}
      // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex
      tabIndex={0}
      onKeyDown={onKeyDown}
      className={classNames(
        frame["frame"],
        styles["line"],
        isBumped && frame["bumped"],
        rule.when === null && styles["incomplete"],
      )}
    >
      <div className={styles["gutter"]}>
        <Badge tone={isBumped ? "bad" : "rest"} className={isBumped ? undefined : styles["badge"]}>
          {line}
        </Badge>
        <RobotFace size={22} mood={isBumped ? "bumped" : "driving"} className={frame["robot"]} />
      </div>
      <span className={classNames(styles["word"], styles["if"])}>
        {index === 0 ? t("program.if") : t("program.elseIf")}
      </span>
      <div className={styles["ask"]}>
        <ConditionMenu index={index} condition={rule.when} remembered={remembered} />
        {rule.when !== null && <ConditionNumber index={index} condition={rule.when} />}
        {(hasTruth || rule.when === null) && (
          <LineTruth feed={feed} condition={rule.when} truth={truth} className={styles["truth"]} />
        )}
      </div>
      <span className={classNames(styles["word"], styles["then"])}>{t("program.then")}</span>
      <div className={styles["do"]}>
        <ActionMenu
          label={t("program.actionOf", { line })}
          value={rule.do}
          onChange={(action) =>
            applyEdit(workspace, setAction(workspace.getState().program, index, action))
          }
        />
        <LineTools
          line={line}
          isFirst={index === 0}
          isLast={index === count - 1}
          onMove={move}
          onDelete={remove}
        />
      </div>
      <LineNote line={index} bump={bump} isInside={adviceText !== null} />
      {adviceText !== null && (
        <div className={styles["advice"]} data-over={isBumped ? "" : undefined}>
          <LazyAdviceNote
            isWanted
            text={adviceText}
            onFix={hasFixes ? fix : undefined}
            onHide={hide}
          />
        </div>
      )}
    </li>
  );
});

/**
 * Restores the focus in a moved line. If the focused button is disabled now, the other move button
 * gets the focus.
 */
function focusAgain(id: number, focused: Element | null, by: -1 | 1): void {
  const line = document.getElementById(lineElementId(id));
  if (line === null) return;
  const isOff = focused instanceof HTMLButtonElement && focused.disabled;
  const other = line.querySelector<HTMLElement>(`[data-move="${by === -1 ? "down" : "up"}"]`);
  const target = isOff ? other : focused;
  if (target instanceof HTMLElement && line.contains(target)) target.focus();
  else line.focus();
  line.scrollIntoView({ block: "nearest" });
}

/** After a deletion, focuses the line that took its place, or the one above. */
function focusNeighbour(ids: readonly number[], index: number): void {
  const id = ids[index] ?? ids[index - 1];
  if (id !== undefined) document.getElementById(lineElementId(id))?.focus();
}
