/** What the form edits, and which field takes the focus because it was just added. */
import { useState } from "react";
import type { LessonDraft } from "./lesson-draft.ts";

export type EditedPart = "lesson" | "task" | "survey";

export interface EditedPartState {
  edited: EditedPart;
  edit: (part: EditedPart) => void;
  /** whose name takes the focus; null: none */
  unnamed: "lesson" | "task" | null;
  /** called when the name has the focus */
  onNamed: () => void;
  /** opens a task that was just added */
  showAdded: () => void;
}

/** A lesson without a name begins with its name. */
export function useEditedPart(draft: LessonDraft): EditedPartState {
  const [first] = useState<"lesson" | null>(() => (draft.lesson.name === "" ? "lesson" : null));
  const [edited, edit] = useState<EditedPart>(first ?? "task");
  const [unnamed, setUnnamed] = useState<EditedPartState["unnamed"]>(first);
  return {
    edited,
    edit,
    unnamed,
    onNamed: () => setUnnamed(null),
    showAdded: () => {
      edit("task");
      setUnnamed("task");
    },
  };
}
