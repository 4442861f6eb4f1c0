/** The parts of the lesson: what it is about, its tasks and their order, and its survey. */
import { MAX_TASKS } from "@corridor/challenge";
import { ArrowDown, ArrowUp, Check, Copy, Ellipsis, Plus, Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button, IconButton } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../../ui/Popover.tsx";
import { Segmented } from "../../../ui/Segmented.tsx";
import { useMediaQuery } from "../../../ui/use-media-query.ts";
import { solutionOf } from "../../../model/teaching/solution.ts";
import { useDraft, useLesson } from "./draft-context.ts";
import styles from "./task-panel.module.css";
import type { EditedPart } from "./use-edited-part.ts";

interface TaskPanelProps {
  edited: EditedPart;
  onEdit: (part: EditedPart) => void;
  onAdd: () => void;
}

export function TaskPanel({ edited, onEdit, onAdd }: TaskPanelProps) {
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const draft = useDraft();
  const lesson = useLesson();
  const open = useStore(draft.store, (state) => state.task);
  const taskIds = useStore(draft.store, (state) => state.taskIds);
  const solutions = useStore(draft.store, (state) => state.solutions);
  const { length } = lesson.tasks;
  const isRow = useMediaQuery("(min-width: 37.5em) and (max-width: 74.99em)");
  return (
    <nav className={styles["panel"]} aria-label={t("lessonEditor:tasks.label")}>
      <PartButton
        name={t("lessonEditor:about.title")}
        isOpen={edited === "lesson"}
        onOpen={() => onEdit("lesson")}
      />
      <ol className={styles["tasks"]}>
        {lesson.tasks.map((task, at) => {
          const isOpen = edited === "task" && at === open;
          const isSolved = solutionOf(solutions, task) !== null;
          return (
            <li key={taskIds[at]} className={styles["item"]}>
              <button
                type="button"
                className={styles["part"]}
                aria-current={isOpen ? "true" : undefined}
                onClick={() => {
                  draft.openTask(at);
                  onEdit("task");
                }}
              >
                <span className={styles["number"]}>{at + 1}</span>
                <span className={styles["name"]} lang={lesson.language ?? undefined} dir="auto">
                  {task.name || t("teach:tasks.unnamed", { number: at + 1 })}
                </span>
                {isSolved && (
                  <>
                    <Icon of={Check} size={16} className={styles["solved"]} />
                    <span className="visually-hidden">{t("teach:saved.solved")}</span>
                  </>
                )}
              </button>
              {at === open && <TaskMenu at={at} count={length} />}
            </li>
          );
        })}
      </ol>
      <Button
        kind="quiet"
        size="small"
        className={styles["add"]}
        icon={<Icon of={Plus} />}
        disabled={length >= MAX_TASKS}
        onClick={onAdd}
      >
        {t("lessonEditor:tasks.add")}
      </Button>
      {length > 1 && (
        <div className={styles["order"]}>
          <Segmented
            label={t("lessonEditor:order.label")}
            showLabel={!isRow}
            value={lesson.order}
            options={[
              { value: "any", label: t("lessonEditor:order.any") },
              { value: "in turn", label: t("lessonEditor:order.inTurn") },
            ]}
            onChange={(order) => draft.edit({ order })}
          />
        </div>
      )}
      <PartButton
        name={
          lesson.survey.length === 0
            ? t("lessonEditor:survey.title")
            : t("lessonEditor:survey.questions", {
                questions: t("teach:saved.questions", { count: lesson.survey.length }),
              })
        }
        isOpen={edited === "survey"}
        onOpen={() => onEdit("survey")}
      />
    </nav>
  );
}

function PartButton(props: { name: string; isOpen: boolean; onOpen: () => void }) {
  return (
    <button
      type="button"
      className={styles["part"]}
      aria-current={props.isOpen ? "true" : undefined}
      onClick={props.onOpen}
    >
      <span className={styles["name"]}>{props.name}</span>
    </button>
  );
}

/** Commands for the open task. */
function TaskMenu({ at, count }: { at: number; count: number }) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const menu = usePopover();
  const label = t("tasks.menu", { number: at + 1 });
  return (
    <>
      <IconButton label={label} {...menu.trigger}>
        <Icon of={Ellipsis} />
      </IconButton>
      <Popover {...menu.panel} label={label} align="end">
        <MenuItem
          icon={<Icon of={ArrowUp} />}
          disabled={at === 0}
          onSelect={() => draft.moveTask(-1)}
        >
          {t("tasks.up")}
        </MenuItem>
        <MenuItem
          icon={<Icon of={ArrowDown} />}
          disabled={at === count - 1}
          onSelect={() => draft.moveTask(1)}
        >
          {t("tasks.down")}
        </MenuItem>
        <MenuItem
          icon={<Icon of={Copy} />}
          disabled={count >= MAX_TASKS}
          onSelect={() => draft.addTasks([draft.task])}
        >
          {t("tasks.duplicate")}
        </MenuItem>
        <MenuItem
          icon={<Icon of={Trash2} />}
          disabled={count === 1}
          onSelect={() => draft.removeTask(at)}
        >
          {t("tasks.delete")}
        </MenuItem>
      </Popover>
    </>
  );
}
