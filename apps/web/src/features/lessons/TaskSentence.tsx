/** The sentence of the open task, where the card of a bump covers the card of the task. */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { TeacherText } from "./TeacherText.tsx";
import { useTask } from "./use-task.ts";
import shared from "./mission-text.module.css";

export function TaskSentence() {
  const { challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.lesson !== null);
  const language = useStore(challenge, ({ mission, lesson }) =>
    mission === null ? (lesson?.language ?? null) : null,
  );
  const task = useTask();
  if (!isOpen || task === "") return null;
  return <TeacherText as="p" className={shared["cardTask"]} text={task} language={language} />;
}
