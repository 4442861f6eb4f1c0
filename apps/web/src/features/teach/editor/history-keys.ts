/** Undo and redo by keyboard, outside of fields, which have a history of their own. */
import type { LessonDraft } from "./lesson-draft.ts";

/** @returns a function that removes the listener */
export function listenToHistoryKeys(draft: Pick<LessonDraft, "undo" | "redo">): () => void {
  const onKey = (event: KeyboardEvent): void => {
    const { key, shiftKey, altKey, ctrlKey, metaKey, target, defaultPrevented } = event;
    if (defaultPrevented || altKey || !(ctrlKey || metaKey) || key.toLowerCase() !== "z") return;
    if (target instanceof Element && target.closest("input[type=text], textarea") !== null) return;
    // A dialog on top of the page receives all keys.
    if (document.querySelector("dialog:modal, :popover-open") !== null) return;
    event.preventDefault();
    if (shiftKey) draft.redo();
    else draft.undo();
  };
  window.addEventListener("keydown", onKey);
  return () => window.removeEventListener("keydown", onKey);
}
