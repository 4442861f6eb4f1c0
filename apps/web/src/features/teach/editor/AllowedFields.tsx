/** What students may do and see in the open task, apart from who drives. */
import {
  conditionNames,
  editKinds,
  helpKinds,
  toolNames,
  type ConditionName,
  type LessonTask,
} from "@corridor/challenge";
import { MAX_RULES, menuActions, paperActions } from "@corridor/program";
import { sensorNames } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { Checkbox } from "../../../ui/Checkbox.tsx";
import { BoundedNumber } from "./BoundedNumber.tsx";
import { useDraft, useOpenTask } from "./draft-context.ts";
import styles from "./form.module.css";
import { toggled } from "./task-edits.ts";

/** Changes that solve the task are shown only where a task lists them. */
const usualHelp = helpKinds.filter((kind) => kind !== "fixes");

export function AllowedFields() {
  const { t } = useTranslation(["lessonEditor", "words"], { useSuspense: false });
  const draft = useDraft();
  const { allowed } = useOpenTask();
  const edit = (change: Partial<LessonTask["allowed"]>, group: string | null = null) =>
    draft.editTask({ allowed: { ...draft.task.allowed, ...change } }, group);
  return (
    <>
      <BoundedNumber
        label={t("lessonEditor:allowed.lines")}
        note={t("lessonEditor:allowed.linesNote")}
        value={allowed.lines}
        min={0}
        max={MAX_RULES}
        onChange={(lines) => edit({ lines }, "lines")}
      />
      <Checkbox
        label={t("lessonEditor:allowed.maze")}
        checked={allowed.maze}
        onChange={(maze) => edit({ maze })}
      />
      <Choices
        label={t("lessonEditor:allowed.edits")}
        all={editKinds}
        chosen={allowed.edits}
        nameOf={(kind) => t(`lessonEditor:edits.${kind}`)}
        onToggle={(kind) => edit({ edits: toggled(editKinds, allowed.edits, kind) })}
      />
      <Choices
        label={t("lessonEditor:allowed.conditions")}
        all={conditionNames}
        chosen={allowed.conditions ?? conditionNames}
        nameOf={(name) => conditionText(name, (sensor) => t(`words:drive.sensor.${sensor}`))}
        onToggle={(name) =>
          edit({
            conditions: orNull(toggled(conditionNames, allowed.conditions, name), conditionNames),
          })
        }
      />
      <Choices
        label={t("lessonEditor:allowed.actions")}
        all={menuActions}
        chosen={allowed.actions ?? paperActions}
        nameOf={(action) => t(`words:program.action.${action}`)}
        onToggle={(action) => {
          const actions = toggled(menuActions, allowed.actions, action, paperActions);
          edit({ actions: orNull(actions, paperActions) });
        }}
      />
      <Choices
        label={t("lessonEditor:allowed.tools")}
        all={toolNames}
        chosen={allowed.tools ?? toolNames}
        nameOf={(tool) => t(`lessonEditor:tools.${tool}`)}
        onToggle={(tool) =>
          edit({ tools: orNull(toggled(toolNames, allowed.tools, tool), toolNames) })
        }
      />
      <Choices
        label={t("lessonEditor:allowed.help")}
        all={helpKinds}
        chosen={allowed.help ?? usualHelp}
        nameOf={(kind) => t(`lessonEditor:help.${kind}`)}
        onToggle={(kind) =>
          edit({ help: orNull(toggled(helpKinds, allowed.help, kind, usualHelp), usualHelp) })
        }
      />
    </>
  );
}

/** Null stands for the usual entries, which older pages read, too. */
function orNull<Name extends string>(list: Name[], usual: readonly Name[]): Name[] | null {
  return list.length === usual.length && usual.every((each) => list.includes(each)) ? null : list;
}

/** "left > right" in the language of the page. */
function conditionText(
  name: ConditionName,
  sensorText: (sensor: (typeof sensorNames)[number]) => string,
): string {
  const words = name.split(" ").map((word) => {
    const sensor = sensorNames.find((each) => each === word);
    return sensor === undefined ? word : sensorText(sensor);
  });
  return words.join(" ");
}

interface ChoicesProps<Name extends string> {
  label: string;
  all: readonly Name[];
  chosen: readonly Name[];
  nameOf: (name: Name) => string;
  onToggle: (name: Name) => void;
}

/** Entries to tick, folded under their number. */
function Choices<Name extends string>(props: ChoicesProps<Name>) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const { label, all, chosen, nameOf, onToggle } = props;
  return (
    <details className={styles["choices"]}>
      <summary className={styles["summary"]}>
        {label}
        <span className={styles["count"]}>
          {t("allowed.of", { count: chosen.length, all: all.length })}
        </span>
      </summary>
      <fieldset className={styles["list"]}>
        <legend className="visually-hidden">{label}</legend>
        {all.map((name) => (
          <Checkbox
            key={name}
            label={nameOf(name)}
            checked={chosen.includes(name)}
            onChange={() => onToggle(name)}
          />
        ))}
      </fieldset>
    </details>
  );
}
