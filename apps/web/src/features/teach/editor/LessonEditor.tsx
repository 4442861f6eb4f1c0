/** The lesson editor: tasks, stage and form side by side, or the same in tabs on a phone. */
import type { LessonDocument } from "@corridor/challenge";
import { emptyProgram, type ProgramDocument } from "@corridor/program";
import { useEffect, useMemo, useRef, useState, type ReactNode, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { useMediaQuery } from "../../../ui/use-media-query.ts";
import type { LessonAutosave } from "./lesson-autosave.ts";
import { withoutBlankTexts } from "../../../model/teaching/blank-texts.ts";
import { lessonName } from "../../../model/lessons/lesson-name.ts";
import { solutionOf } from "../../../model/teaching/solution.ts";
import { StartClassDialog } from "../start/lazy-start-class-dialog.ts";
import { ShareLessonDialog } from "../share/lazy-share-lesson-dialog.ts";
import { TeachFrame } from "../frame/TeachFrame.tsx";
import type { TeachSlots, TrialProps, WorkbenchParts } from "../frame/teach-slots.ts";
import { EditorBar, EditorBarEnd } from "./EditorBar.tsx";
import { EditorPanels } from "./EditorPanels.tsx";
import type { LessonDraft } from "./lesson-draft.ts";
import { PhoneEditor } from "./PhoneEditor.tsx";
import { AddTaskDialog } from "./lazy-add-task-dialog.ts";
import { TrialBand } from "./TrialBand.tsx";
import { useEditedPart } from "./use-edited-part.ts";
import { listenToHistoryKeys } from "./history-keys.ts";

/** The lines of a task that starts with none. */
const noLines = emptyProgram();

/** A lesson that the teacher tries as a student. */
interface Trial {
  lesson: LessonDocument;
  program: ProgramDocument | null;
  /** whether the trial is to solve the open task */
  isSolving: boolean;
  /** index of the open task */
  task: number;
  onSolved: TrialProps["onSolved"];
}

interface LessonEditorProps {
  draft: LessonDraft;
  autosave: LessonAutosave;
  /** localStorage */
  device: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
  slots: TeachSlots;
  main: RefObject<HTMLElement | null>;
}

export function LessonEditor(props: LessonEditorProps) {
  const { draft, autosave, device, tools, slots, main } = props;
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  const lesson = useStore(draft.store, (state) => state.lesson);
  const solutions = useStore(draft.store, (state) => state.solutions);
  const [trial, setTrial] = useState<Trial | null>(null);
  const [isSharing, setSharing] = useState(false);
  const [isStarting, setStarting] = useState(false);
  const [isAdding, setAdding] = useState(false);
  const isAdded = useRef(false);
  const part = useEditedPart(draft);
  // What students receive.
  const shared = useMemo(() => withoutBlankTexts(lesson), [lesson]);
  const title = t("lessonEditor:pageTitle", {
    name: lessonName(lesson) || t("teach:lesson.unnamed"),
  });
  const tryLesson = () =>
    setTrial({
      lesson: shared,
      program: null,
      isSolving: false,
      task: draft.store.getState().task,
      onSolved: draft.startTrial("try"),
    });
  const solve = (): void => {
    const { task } = draft;
    const { solutions: known, task: index } = draft.store.getState();
    const program = solutionOf(known, task)?.program ?? null;
    // Only this task: in a lesson in turn, it may not be open yet.
    const alone = { ...draft.lesson, order: "any" as const, tasks: [task] };
    setSharing(false);
    const onSolved = draft.startTrial("solve");
    setTrial({ lesson: alone, program, isSolving: true, task: index, onSolved });
  };
  if (trial !== null) {
    return (
      <slots.Trial
        // Each task to solve opens a student's page of its own.
        key={trial.task}
        lesson={trial.lesson}
        program={trial.program}
        onSolved={trial.onSolved}
        band={
          <TrialBand
            title={title}
            isSolving={trial.isSolving}
            onNext={(task) => {
              draft.openTask(task);
              solve();
            }}
            onClose={() => {
              setTrial(null);
              // The button is gone.
              requestAnimationFrame(() => main.current?.focus());
            }}
          />
        }
      />
    );
  }
  const commands = {
    onTry: tryLesson,
    onStart: () => setStarting(true),
    onShare: () => setSharing(true),
  };
  return (
    <TeachFrame
      title={title}
      isFull
      main={main}
      bar={<EditorBar autosave={autosave} />}
      end={<EditorBarEnd isPhone={isPhone} autosave={autosave} tools={tools} {...commands} />}
    >
      <EditorWorkbench draft={draft} slots={slots}>
        {(parts) => {
          const props = { parts, part, onSolve: solve, onAdd: () => setAdding(true) };
          return isPhone ? <PhoneEditor {...props} /> : <EditorPanels {...props} />;
        }}
      </EditorWorkbench>
      <ShareLessonDialog
        isOpen={isSharing}
        lesson={shared}
        device={device}
        isSolved={lesson.tasks.every((task) => solutionOf(solutions, task) !== null)}
        onSolve={solve}
        onClose={() => setSharing(false)}
      />
      <StartClassDialog
        isOpen={isStarting}
        lesson={shared}
        device={device}
        onClose={() => setStarting(false)}
      />
      <AddTaskDialog
        isOpen={isAdding}
        device={device}
        onAdded={() => {
          isAdded.current = true;
          setAdding(false);
        }}
        onClose={() => {
          setAdding(false);
          // A dialog that closes first returns the focus to its button.
          if (isAdded.current) part.showAdded();
          isAdded.current = false;
        }}
      />
    </TeachFrame>
  );
}

interface EditorWorkbenchProps {
  draft: LessonDraft;
  slots: TeachSlots;
  children: (parts: WorkbenchParts) => ReactNode;
}

/** Connects the stage and the lines with the open task. */
function EditorWorkbench({ draft, slots, children }: EditorWorkbenchProps) {
  const maze = useStore(draft.store, (state) => {
    const { mazes } = state.lesson.tasks[state.task] ?? { mazes: [] };
    return mazes[state.maze] ?? mazes[0] ?? null;
  });
  const program = useStore(draft.store, ({ lesson, task }) => lesson.tasks[task]?.program ?? null);
  useEffect(() => listenToHistoryKeys(draft), [draft]);
  if (maze === null) return null;
  return (
    <slots.Workbench
      maze={maze}
      program={program ?? noLines}
      onMaze={(edited) => draft.setMaze(edited)}
      onProgram={(edited) => draft.editTask({ program: edited })}
    >
      {(parts) => <div onBlur={() => draft.endGroup()}>{children(parts)}</div>}
    </slots.Workbench>
  );
}
