/** Tasks, stage and form side by side. */
import { useState } from "react";
import type { WorkbenchParts } from "../frame/teach-slots.ts";
import { AboutLesson } from "./AboutLesson.tsx";
import { MazePanel } from "./MazePanel.tsx";
import { StatusPanel } from "./StatusPanel.tsx";
import { SurveyFields } from "./SurveyFields.tsx";
import { TaskPanel, type EditedPart } from "./TaskPanel.tsx";
import { TaskRules } from "./TaskRules.tsx";
import { TaskWords } from "./TaskWords.tsx";
import styles from "./lesson-editor.module.css";

export interface EditorPartProps {
  parts: WorkbenchParts;
  onSolve: () => void;
}

export function EditorPanels({ parts, onSolve }: EditorPartProps) {
  const [edited, setEdited] = useState<EditedPart>("task");
  return (
    <div className={styles["editor"]}>
      <div className={styles["tasks"]}>
        <TaskPanel edited={edited} onEdit={setEdited} />
      </div>
      <div className={styles["status"]}>
        <StatusPanel onSolve={onSolve} />
      </div>
      <div className={styles["maze"]}>
        <MazePanel stage={parts.stage} />
      </div>
      <div className={styles["form"]}>
        {edited === "lesson" && <AboutLesson />}
        {edited === "survey" && <SurveyFields />}
        {edited === "task" && (
          <>
            <TaskWords />
            <TaskRules lines={parts.lines} />
          </>
        )}
      </div>
    </div>
  );
}
