/** The editor on a phone: tasks, maze, words and rules as tabs. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Tabs } from "../../../ui/Tabs.tsx";
import { AboutLesson } from "./AboutLesson.tsx";
import type { EditorPartProps } from "./EditorPanels.tsx";
import { MazePanel } from "./MazePanel.tsx";
import { StatusPanel } from "./StatusPanel.tsx";
import { SurveyFields } from "./SurveyFields.tsx";
import { TaskPanel } from "./TaskPanel.tsx";
import { TaskRules } from "./TaskRules.tsx";
import { TaskWords } from "./TaskWords.tsx";
import styles from "./lesson-editor.module.css";

const tabs = ["tasks", "maze", "words", "rules"] as const;

export function PhoneEditor({ parts, part, onSolve, onAdd }: EditorPartProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const [tab, setTab] = useState<(typeof tabs)[number]>("tasks");
  const { edited, edit, unnamed, onNamed } = part;
  // The name of a task is in another tab than the button that adds it.
  if (unnamed === "task" && tab !== "words") setTab("words");
  return (
    <div className={styles["phone"]}>
      <Tabs
        label={t("tabs.label")}
        value={tab}
        tabs={tabs.map((value) => ({ value, label: t(`tabs.${value}`) }))}
        onChange={setTab}
        panelClassName={styles["tab"]}
      >
        {tab === "tasks" && (
          <>
            <TaskPanel edited={edited} onEdit={edit} onAdd={onAdd} />
            {edited === "lesson" && (
              <AboutLesson
                isNew={unnamed === "lesson"}
                onNamed={onNamed}
                onNext={() => {
                  edit("task");
                  setTab("words");
                }}
              />
            )}
            {edited === "survey" && <SurveyFields />}
            <StatusPanel onSolve={onSolve} />
          </>
        )}
        {tab === "maze" && <MazePanel stage={parts.stage} />}
        {tab === "words" && <TaskWords isNew={unnamed === "task"} onNamed={onNamed} />}
        {tab === "rules" && <TaskRules lines={parts.lines} />}
      </Tabs>
    </div>
  );
}
