/** One line of the program as a sentence: if …, then …, and whether it is true now. */
import type { Rule } from "@corridor/program";
import { setAction } from "@corridor/program";
import { Check, X } from "lucide-react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import { tell } from "../../stores/screen-store.ts";
import { Badge } from "../../ui/Badge.tsx";
import { classNames } from "../../ui/class-names.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { ActionMenu } from "./ActionMenu.tsx";
import { ConditionMenu, ConditionNumber } from "./ConditionField.tsx";
import type { LineState } from "./line-state.ts";
import { LineTools } from "./LineTools.tsx";
import { applyEdit, deleteLine, moveLine, type RememberedNumbers } from "./program-actions.ts";
import styles from "./program.module.css";
import { truthText } from "./truth-text.ts";
import { useLineName } from "./use-line-name.ts";

interface ProgramLineProps {
  id: number;
  index: number;
  count: number;
  rule: Rule;
  state: LineState;
  remembered: RememberedNumbers;
}

export function ProgramLine({ id, index, count, rule, state, remembered }: ProgramLineProps) {
  const { t } = useTranslation();
  const { workspace, screen } = useServices();
  const name = useLineName(index, rule, state);
  const line = index + 1;

  function move(by: -1 | 1) {
    // Moving the element takes its focus away: it is given back as soon as the line has its new place.
    const focused = document.activeElement;
    flushSync(() => moveLine(workspace, index, by));
    focusAgain(id, focused, by);
  }

  function remove() {
    const bringBack = deleteLine(workspace, index);
    tell(screen, {
      tone: "info",
      text: t("program.deleted", { line }),
      action: { label: t("program.undo"), run: bringBack },
    });
    focusNeighbour(workspace.getState().lineIds, index);
  }

  function onKeyDown(event: React.KeyboardEvent) {
    const isTyping = event.target instanceof HTMLInputElement;
    if (event.altKey && (event.key === "ArrowUp" || event.key === "ArrowDown")) {
      event.preventDefault();
      move(event.key === "ArrowUp" ? -1 : 1);
    } else if (event.key === "Delete" && !isTyping) {
      event.preventDefault();
      remove();
    }
  }

  // A line is a stop of the Tab key itself: one that has the focus is moved and deleted by keys.
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions
    <li
      id={lineElementId(id)}
      aria-label={name}
      aria-current={state.isDeciding ? "step" : undefined}
      // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex
      tabIndex={0}
      onKeyDown={onKeyDown}
      className={classNames(
        styles["line"],
        state.isDeciding && styles["deciding"],
        state.isPassedOver && styles["passedOver"],
      )}
    >
      <div className={styles["gutter"]}>
        <Badge tone={state.isDeciding ? "live" : "rest"}>{line}</Badge>
        {state.isDeciding && <RobotFace size={22} className={styles["robot"]} />}
      </div>
      <span className={classNames(styles["word"], styles["if"])}>
        {index === 0 ? t("program.if") : t("program.elseIf")}
      </span>
      <div className={classNames(styles["ask"], rule.when?.than === "right" && styles["compares"])}>
        <ConditionMenu index={index} condition={rule.when} remembered={remembered} />
        {rule.when !== null && <ConditionNumber index={index} condition={rule.when} />}
        <TruthMark rule={rule} state={state} />
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
    </li>
  );
}

/** A tick or a cross with both numbers; a line that does nothing is skipped. */
function TruthMark({ rule, state }: { rule: Rule; state: LineState }) {
  const { t } = useTranslation();
  if (rule.when === null) {
    return <span className={styles["truth"]}>{t("program.skipped")}</span>;
  }
  if (state.truth === null) return null;
  const { isTrue } = state.truth;
  const { left, right } = truthText(state.truth);
  return (
    <span className={classNames(styles["truth"], isTrue && styles["true"])}>
      <span className={styles["mark"]}>
        {isTrue ? <Check size={14} aria-hidden="true" /> : <X size={14} aria-hidden="true" />}
        <span className="visually-hidden">{t(isTrue ? "program.true" : "program.false")}</span>
        {left}
      </span>{" "}
      <span>{right}</span>
    </span>
  );
}

function lineElementId(id: number): string {
  return `program-line-${id}`;
}

/** Gives the focus back to where it was in the moved line; from a button that is off now, to the other. */
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

/** After a deletion the focus goes to the line that took the place, or to the one above. */
function focusNeighbour(ids: readonly number[], index: number): void {
  const id = ids[index] ?? ids[index - 1];
  if (id !== undefined) document.getElementById(lineElementId(id))?.focus();
}
