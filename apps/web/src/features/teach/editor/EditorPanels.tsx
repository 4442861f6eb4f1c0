/** Tasks, stage and form side by side. */
import type { WorkbenchParts } from "../frame/teach-slots.ts";
import { AboutLesson } from "./AboutLesson.tsx";
import { MazePanel } from "./MazePanel.tsx";
import { StatusPanel } from "./StatusPanel.tsx";
import { SurveyFields } from "./SurveyFields.tsx";
import { TaskPanel } from "./TaskPanel.tsx";
import { TaskRules } from "./TaskRules.tsx";
import { TaskWords } from "./TaskWords.tsx";
import styles from "./lesson-editor.module.css";
import type { EditedPartState } from "./use-edited-part.ts";

export interface EditorPartProps {
  parts: WorkbenchParts;
  part: EditedPartState;
  onSolve: () => void;
  /** asks with what a further task begins */
  onAdd: () => void;
}

export function EditorPanels({ parts, part, onSolve, onAdd }: EditorPartProps) {
  const { edited, edit, unnamed, onNamed } = part;
  return (
    <div className={styles["editor"]}>
      <div className={styles["tasks"]}>
        <TaskPanel edited={edited} onEdit={edit} onAdd={onAdd} />
      </div>
      <div className={styles["status"]}>
        <StatusPanel onSolve={onSolve} />
      </div>
      <div className={styles["maze"]}>
        <MazePanel stage={parts.stage} />
      </div>
      <div className={styles["form"]}>
        {edited === "lesson" && (
          <AboutLesson isNew={unnamed === "lesson"} onNamed={onNamed} onNext={() => edit("task")} />
        )}
        {edited === "survey" && <SurveyFields />}
        {edited === "task" && (
          <>
            <TaskWords isNew={unnamed === "task"} onNamed={onNamed} />
            <TaskRules lines={parts.lines} />
          </>
        )}
      </div>
    </div>
  );
}
