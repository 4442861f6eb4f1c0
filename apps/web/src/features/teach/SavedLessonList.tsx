/** The lessons that the teacher saved on this device. */
import { Copy, Ellipsis, ListChecks, Printer, Share2, SquarePen, Trash2, Users } from "lucide";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { newTextId } from "../../model/storage/new-text-id.ts";
import { Button, IconButton } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import { Icon } from "../../ui/Icon.tsx";
import { MazePicture } from "../../ui/MazePicture.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { PrintDialog } from "../../ui/print/lazy-print-dialog.ts";
import { ProblemNote } from "../../ui/ProblemNote.tsx";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import { SavedLessons, type SavedLesson } from "../../model/teaching/saved-lessons.ts";
import { SharedLessons } from "../../model/teaching/shared-lessons.ts";
import { solutionOf } from "../../model/teaching/solution.ts";
import { printedLesson } from "./share/printed-lesson.ts";
import { ShareLessonDialog } from "./share/lazy-share-lesson-dialog.ts";
import { StartClassDialog } from "./start/lazy-start-class-dialog.ts";
import { handInsHash, lessonHash } from "./frame/teach-view.ts";
import entries from "./frame/device-list.module.css";
import styles from "./saved-lesson-list.module.css";

export function SavedLessonList({ device }: { device: KeyValueStorage }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const [lessons] = useState(() => new SavedLessons(device));
  const [list, setList] = useState(() => lessons.list());
  const [deleted, setDeleted] = useState<SavedLesson | null>(null);
  const [shared, setShared] = useState<SavedLesson | null>(null);
  const [isSharing, setSharing] = useState(false);
  const [started, setStarted] = useState<SavedLesson | null>(null);
  const [isStarting, setStarting] = useState(false);
  const [printed, setPrinted] = useState<SavedLesson | null>(null);
  const [isPrinting, setPrinting] = useState(false);
  const [isBlocked, setBlocked] = useState(false);
  useEffect(() => {
    // Another tab saved or deleted a lesson.
    const refresh = () => setList(lessons.list());
    window.addEventListener("storage", refresh);
    return () => window.removeEventListener("storage", refresh);
  }, [lessons]);

  function write(entry: SavedLesson): void {
    try {
      lessons.write(entry);
      setBlocked(false);
    } catch {
      setBlocked(true);
    }
    setDeleted(null);
    setList(lessons.list());
  }

  if (list.length === 0 && deleted === null) return null;
  return (
    <section className={entries["section"]} aria-labelledby="saved-lessons">
      <h3 id="saved-lessons" className={entries["heading"]}>
        {t("saved.heading")}
      </h3>
      {isBlocked && (
        <ProblemNote>
          <p>{t("saved.blocked")}</p>
        </ProblemNote>
      )}
      <output className={entries["deleted"]}>
        {deleted !== null && (
          <>
            {t("saved.deleted", { name: lessonName(deleted.lesson) || t("lesson.unnamed") })}
            <Button size="small" onClick={() => write(deleted)}>
              {t("saved.undo")}
            </Button>
          </>
        )}
      </output>
      <ul className={entries["list"]}>
        {list.map((saved) => (
          <SavedLessonRow
            key={saved.id}
            saved={saved}
            canDuplicate={!lessons.isFull}
            onStart={() => {
              setStarted(saved);
              setStarting(true);
            }}
            onShare={() => {
              setShared(saved);
              setSharing(true);
            }}
            onPrint={() => {
              new SharedLessons(device).add(saved.lesson);
              setPrinted(saved);
              setPrinting(true);
            }}
            onDuplicate={() =>
              write({ ...saved, id: newTextId(), revision: newTextId(), savedAt: Date.now() })
            }
            onDelete={() => {
              // Another tab may have saved it since it was listed.
              setDeleted(lessons.read(saved.id) ?? saved);
              lessons.remove(saved.id);
              setList(lessons.list());
            }}
          />
        ))}
      </ul>
      {printed !== null && (
        <PrintDialog
          isOpen={isPrinting}
          content={printedLesson(printed.lesson)}
          onClose={() => setPrinting(false)}
        />
      )}
      {shared !== null && (
        <ShareLessonDialog
          isOpen={isSharing}
          lesson={shared.lesson}
          isSolved={isSolved(shared)}
          device={device}
          onSolve={() => (location.hash = lessonHash(shared.id))}
          onClose={() => setSharing(false)}
        />
      )}
      {started !== null && (
        <StartClassDialog
          isOpen={isStarting}
          lesson={started.lesson}
          device={device}
          onClose={() => setStarting(false)}
        />
      )}
    </section>
  );
}

interface RowProps {
  saved: SavedLesson;
  canDuplicate: boolean;
  onStart: () => void;
  onShare: () => void;
  onPrint: () => void;
  onDuplicate: () => void;
  onDelete: () => void;
}

function SavedLessonRow(props: RowProps) {
  const { saved, canDuplicate, onStart, onShare, onPrint, onDuplicate, onDelete } = props;
  const { t } = useTranslation(["teach", "print"], { useSuspense: false });
  const menu = usePopover();
  const { id, lesson } = saved;
  const name = lessonName(lesson) || t("lesson.unnamed");
  const [maze] = lesson.tasks[0]?.mazes ?? [];
  const facts = [
    t("lesson.tasks", { count: lesson.tasks.length }),
    ...(lesson.survey.length === 0 ? [] : [t("saved.questions", { count: lesson.survey.length })]),
  ];
  return (
    <li className={entries["row"]}>
      <span className={styles["picture"]}>{maze !== undefined && <MazePicture maze={maze} />}</span>
      <div className={entries["words"]}>
        <a
          className={styles["name"]}
          href={lessonHash(id)}
          lang={lesson.language ?? undefined}
          dir="auto"
        >
          {name}
        </a>
        <span className={classNames(entries["note"], styles["facts"])}>
          {facts.map((fact) => (
            <span key={fact}>{fact}</span>
          ))}
          {isSolved(saved) && <span className={styles["solved"]}>{t("saved.solved")}</span>}
        </span>
      </div>
      <div className={entries["actions"]}>
        <Button size="small" icon={<Icon of={Users} />} onClick={onStart}>
          {t("class.startShort")}
        </Button>
        <Button size="small" icon={<Icon of={Share2} />} onClick={onShare}>
          {t("saved.share")}
        </Button>
        <IconButton label={t("saved.more", { name })} kind="outline" {...menu.trigger}>
          <Icon of={Ellipsis} />
        </IconButton>
        <Popover {...menu.panel} label={t("saved.more", { name })} align="end">
          <MenuItem
            icon={<Icon of={SquarePen} />}
            onSelect={() => (location.hash = lessonHash(id))}
          >
            {t("saved.open")}
          </MenuItem>
          <MenuItem
            icon={<Icon of={ListChecks} />}
            onSelect={() => (location.hash = handInsHash(id))}
          >
            {t("saved.handIns")}
          </MenuItem>
          <MenuItem icon={<Icon of={Printer} />} onSelect={onPrint}>
            {t("print:print")}
          </MenuItem>
          <MenuItem icon={<Icon of={Copy} />} disabled={!canDuplicate} onSelect={onDuplicate}>
            {t("saved.duplicate")}
          </MenuItem>
          <MenuItem icon={<Icon of={Trash2} />} onSelect={onDelete}>
            {t("saved.delete")}
          </MenuItem>
        </Popover>
      </div>
    </li>
  );
}

/** Whether the teacher solved every task as it is now. */
function isSolved({ lesson, solutions }: SavedLesson): boolean {
  return lesson.tasks.every((task) => solutionOf(solutions, task) !== null);
}
