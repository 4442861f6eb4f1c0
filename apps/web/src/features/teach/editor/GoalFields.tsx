/** The goal of the open task. */
import { MAX_GOAL_DISTANCE, MAX_LESSON_SECONDS, type Goal } from "@corridor/challenge";
import { sensorNames } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { Select } from "../../../ui/Select.tsx";
import { BoundedNumber } from "./BoundedNumber.tsx";
import { useDraft, useOpenTask } from "./draft-context.ts";
import field from "../../../ui/field.module.css";
import styles from "./form.module.css";
import { withGoal, withGoalKind } from "./task-edits.ts";

const kinds = ["reach", "visit", "stop", "drive", "last"] as const satisfies Goal["kind"][];

export function GoalFields() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { goal } = useOpenTask();
  return (
    <div className={styles["group"]}>
      <Select
        label={t("goal.title")}
        value={goal.kind}
        options={kinds.map((value) => ({ value, label: t(`goal.${value}`) }))}
        onChange={(kind) => draft.setTask(withGoalKind(draft.task, kind))}
      />
      <GoalNumbers goal={goal} />
    </div>
  );
}

function GoalNumbers({ goal }: { goal: Goal }) {
  const { t } = useTranslation(["lessonEditor", "words"], { useSuspense: false });
  const draft = useDraft();
  const edit = (next: Goal, group: string | null = null) =>
    draft.setTask(withGoal(draft.task, next), group);
  switch (goal.kind) {
    case "reach":
    case "visit":
      return null;
    case "stop":
      return (
        <div className={styles["pair"]}>
          <div className={styles["choice"]}>
            <span className={field["label"]} aria-hidden="true">
              {t("lessonEditor:goal.sensor")}
            </span>
            <Select
              label={t("lessonEditor:goal.sensor")}
              value={goal.sensor}
              options={sensorNames.map((value) => ({
                value,
                label: t(`words:drive.sensor.${value}`),
              }))}
              onChange={(sensor) => edit({ ...goal, sensor })}
            />
          </div>
          <BoundedNumber
            label={t("lessonEditor:goal.from")}
            value={goal.from}
            min={0}
            max={MAX_GOAL_DISTANCE}
            onChange={(from) => edit({ ...goal, from }, "from")}
          />
          <BoundedNumber
            label={t("lessonEditor:goal.to")}
            value={goal.to}
            min={0}
            max={MAX_GOAL_DISTANCE}
            onChange={(to) => edit({ ...goal, to }, "to")}
          />
        </div>
      );
    case "drive":
      return (
        <BoundedNumber
          label={t("lessonEditor:goal.distance")}
          value={goal.distance}
          min={1}
          max={MAX_GOAL_DISTANCE}
          onChange={(distance) => edit({ ...goal, distance }, "distance")}
        />
      );
    case "last":
      return (
        <BoundedNumber
          label={t("lessonEditor:goal.seconds")}
          value={goal.seconds}
          min={1}
          max={MAX_LESSON_SECONDS}
          onChange={(seconds) => edit({ ...goal, seconds }, "last")}
        />
      );
  }
}
