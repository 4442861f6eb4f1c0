/** The condition menu of a line and its number. */
import {
  conditionKinds,
  kindOf,
  numberOf,
  numberRange,
  setNumber,
  type Condition,
} from "@corridor/program";
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { beginStroke } from "../../model/workspace/workspace-store.ts";
import { classNames } from "../../ui/class-names.ts";
import { FieldError } from "../../ui/FieldError.tsx";
import { NumberInput } from "../../ui/NumberInput.tsx";
import { Select } from "../../ui/Select.tsx";
import { useNumberDraft } from "../../ui/use-number-draft.ts";
import { useRights } from "../../model/use-rights.ts";
import { choiceOf, DO_NOTHING, kindOfChoice } from "./condition-menu.ts";
import {
  applyEdit,
  chooseCondition,
  type RememberedNumbers,
} from "../../model/workspace/program-actions.ts";
import { SensorIcon } from "../../ui/ProgramIcons.tsx";
import styles from "./condition-field.module.css";

interface ConditionMenuProps {
  index: number;
  condition: Condition | null;
  remembered: RememberedNumbers;
}

/** Menu of the conditions in the paper. */
export function ConditionMenu({ index, condition, remembered }: ConditionMenuProps) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const rights = useRights();
  const own = condition === null ? null : kindOf(condition);
  const offered = conditionKinds.filter(
    (kind) => kind === own || (rights?.conditions.includes(kind) ?? true),
  );
  const isFixed = rights?.edits.has("condition") === false;
  const options = [
    { value: DO_NOTHING, label: t("program.doNothing") },
    ...offered.map((kind) => ({
      value: String(conditionKinds.indexOf(kind)),
      label:
        kind.than === "right"
          ? `${t("program.sensor.left")} ${kind.is} ${t("program.sensor.right")} +`
          : `${t(`program.sensor.${kind.sensor}`)} ${kind.is}`,
    })),
  ];
  return (
    <Select
      label={t("program.conditionOf", { line: index + 1 })}
      className={classNames(styles["condition"], isFixed && styles["fixed"])}
      value={choiceOf(condition)}
      options={options}
      disabled={isFixed}
      title={isFixed ? t("lessons.partFixed") : undefined}
      icon={<SensorIcon kind={own} />}
      onChange={(choice) => chooseCondition(workspace, index, kindOfChoice(choice), remembered)}
    />
  );
}

/** The number of a condition. All edits between focus and blur form one step of the history. */
export function ConditionNumber({ index, condition }: { index: number; condition: Condition }) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const rights = useRights();
  const isFixed = rights?.edits.has("number") === false;
  const endStroke = useRef<(() => void) | null>(null);
  const range = numberRange(kindOf(condition));
  const draft = useNumberDraft(numberOf(condition), range, (number) => {
    endStroke.current ??= beginStroke(workspace);
    applyEdit(workspace, setNumber(workspace.getState().program, index, number));
  });
  // A line can disappear while its number is being typed. The history must not stay paused.
  useEffect(() => () => endStroke.current?.(), []);
  const errorId = `line-${index}-number-error`;
  return (
    <>
      <NumberInput
        draft={draft}
        errorId={errorId}
        className={classNames(styles["number"], isFixed && styles["fixed"])}
        disabled={isFixed}
        title={isFixed ? t("lessons.partFixed") : undefined}
        aria-label={t("program.numberOf", { line: index + 1 })}
        onBlur={() => {
          endStroke.current?.();
          endStroke.current = null;
        }}
      />
      {draft.hasErrorRoom && (
        <div className={styles["error"]} data-over={draft.isInvalid ? undefined : ""}>
          <FieldError id={errorId}>{t("program.badNumber", range)}</FieldError>
        </div>
      )}
    </>
  );
}
