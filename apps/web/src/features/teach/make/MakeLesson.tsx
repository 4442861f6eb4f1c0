/**
 * The beginnings of a lesson: the open maze, an empty one, a file, the study of 2013, a link, or a copy
 * of a mission.
 */
import type { LessonDocument } from "@corridor/challenge";
import { FolderOpen, SquareDashed } from "lucide";
import { useEffect, useEffectEvent, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { missions } from "../../../model/lessons/missions/missions.ts";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { Button } from "../../../ui/Button.tsx";
import { DropView } from "../../../ui/DropView.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { chooseFiles, type TextFile } from "../../../ui/incoming-files.ts";
import { MazePicture } from "../../../ui/MazePicture.tsx";
import { ProblemNote } from "../../../ui/ProblemNote.tsx";
import { TextField } from "../../../ui/TextField.tsx";
import { LessonProblemNote } from "../lessons/LessonProblemNote.tsx";
import { MAX_SAVED_LESSONS, SavedLessons } from "../../../model/teaching/saved-lessons.ts";
import {
  lessonOfShared,
  readLessonFile,
  type LessonProblem,
  type OpenedLesson,
} from "../lessons/read-lesson.ts";
import { readTyped } from "../lessons/read-typed-lesson.ts";
import { lessonHash } from "../frame/teach-view.ts";
import { beginLesson, beginShared, openMaze, type Begun } from "./begin-lesson.ts";
import styles from "./make-lesson.module.css";
import {
  emptyMaze,
  lessonOfMaze,
  missionLesson,
  newLesson,
  newTask,
} from "../lessons/new-lesson.ts";
import { study2013, studyMissions } from "../lessons/study-2013.ts";

interface MakeLessonProps {
  /** localStorage */
  device: KeyValueStorage;
  /** link of a lesson or a maze in the address, which opens at once; null without one */
  link: string | null;
}

export function MakeLesson({ device, link }: MakeLessonProps) {
  const { t, ready } = useTranslation("teach", { useSuspense: false });
  const [lessons] = useState(() => new SavedLessons(device));
  const [maze] = useState(() => openMaze(device));
  const [problem, setProblem] = useState<LessonProblem | null>(null);
  const [refusal, setRefusal] = useState<"full" | "blocked" | null>(null);
  const [isOpening, setOpening] = useState(link !== null);
  const task = t("make.taskName", { number: 1 });

  function follow(begun: Begun, isLink = false): void {
    setProblem(null);
    setRefusal(begun.ok ? null : begun.code);
    if (!begun.ok) return;
    // Back leads to the page before the link.
    if (isLink) location.replace(lessonHash(begun.id));
    else location.hash = lessonHash(begun.id);
  }

  function receive(opened: OpenedLesson, isLink = false): void {
    setOpening(false);
    if (opened.ok) follow(beginShared(lessons, opened.lesson), isLink);
    else setProblem({ code: opened.code, problems: opened.problems });
  }

  async function openText(text: string): Promise<void> {
    setOpening(true);
    receive(await readBeginning(text));
  }

  async function openFiles([file]: readonly TextFile[]): Promise<void> {
    if (file !== undefined) receive(await readLessonFile(file));
  }

  async function readBeginning(text: string): Promise<OpenedLesson> {
    const shared = await readTyped(text);
    const lesson = shared.ok ? lessonOfMaze(shared.content, task) : null;
    return lesson === null ? lessonOfShared(shared) : { ok: true, lesson };
  }

  const readLink = useEffectEvent((text: string) => readBeginning(text));
  const receiveLink = useEffectEvent((opened: OpenedLesson) => receive(opened, true));
  useEffect(() => {
    // The name of a first task is a text, so it waits until the texts are loaded.
    if (link !== null && ready) void readLink(link).then((opened) => receiveLink(opened));
  }, [link, ready]);

  const begin = (lesson: LessonDocument): void => follow(beginLesson(lessons, lesson));
  return (
    <DropView
      title={t("make.title")}
      drop={t("make.drop")}
      onFiles={(files) => void openFiles(files)}
      onText={(text) => void openText(text)}
    >
      {refusal !== null && (
        <ProblemNote>
          <p>{t(`make.refusals.${refusal}`, { most: MAX_SAVED_LESSONS })}</p>
        </ProblemNote>
      )}
      {problem !== null && <LessonProblemNote problem={problem} />}
      <ul className={styles["beginnings"]}>
        {maze !== null && (
          <Beginning
            name={t("make.open.name")}
            note={maze.name || t("make.open.unnamed")}
            picture={<MazePicture maze={maze} />}
            onChoose={() => begin(newLesson(newTask(maze, task), maze.name))}
          />
        )}
        <Beginning
          name={t("make.empty.name")}
          note={t("make.empty.note")}
          picture={<Icon of={SquareDashed} />}
          onChoose={() => begin(newLesson(newTask(emptyMaze(t("make.mazeName")), task), ""))}
        />
        <Beginning
          name={t("make.file.name")}
          note={t("make.file.note")}
          picture={<Icon of={FolderOpen} />}
          onChoose={() => chooseFiles((files) => void openFiles(files))}
        />
        <Study onChoose={begin} />
      </ul>
      <LinkForm isOpening={isOpening} isInvalid={problem !== null} onOpen={openText} />
      <Missions onChoose={begin} />
    </DropView>
  );
}

interface BeginningProps {
  name: string;
  note?: string;
  picture: ReactNode;
  onChoose: () => void;
}

function Beginning({ name, note, picture, onChoose }: BeginningProps) {
  return (
    <li className={styles["item"]}>
      <button type="button" className={styles["beginning"]} onClick={onChoose}>
        <span className={styles["picture"]}>{picture}</span>
        <span className={styles["name"]}>{name}</span>
        {note !== undefined && <span className={styles["note"]}>{note}</span>}
      </button>
    </li>
  );
}

/** The study of 2013, in the language of the page. */
function Study({ onChoose }: { onChoose: (lesson: LessonDocument) => void }) {
  const { t, i18n, ready } = useTranslation(["teach", "missions"], { useSuspense: false });
  const maze = studyMissions.at(-1)?.challenge.mazes[0];
  if (!ready) return null;
  return (
    <Beginning
      name={t("teach:study.name")}
      note={t("teach:study.note")}
      picture={maze !== undefined && <MazePicture maze={maze} />}
      onChoose={() => onChoose(study2013(i18n))}
    />
  );
}

interface LinkFormProps {
  isOpening: boolean;
  isInvalid: boolean;
  onOpen: (text: string) => Promise<void>;
}

function LinkForm({ isOpening, isInvalid, onOpen }: LinkFormProps) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const [text, setText] = useState("");
  return (
    <form
      className={styles["form"]}
      onSubmit={(event) => {
        event.preventDefault();
        if (text.trim() !== "") void onOpen(text);
      }}
    >
      <div className={styles["field"]}>
        <TextField
          label={t("make.link")}
          value={text}
          onChange={setText}
          dir="ltr"
          spellCheck={false}
          aria-invalid={isInvalid}
        />
      </div>
      <Button type="submit" disabled={isOpening}>
        {t("lesson.open")}
      </Button>
      <output className="visually-hidden">{isOpening ? t("lesson.opening") : ""}</output>
    </form>
  );
}

/** Copies of Corridor's own missions, in the language of the page. */
function Missions({ onChoose }: { onChoose: (lesson: LessonDocument) => void }) {
  const { t, i18n, ready } = useTranslation(["missions", "teach"], { useSuspense: false });
  if (!ready) return null;
  return (
    <section className={styles["missions"]} aria-labelledby="missions">
      <h3 id="missions" className={styles["heading"]}>
        {t("teach:make.missions")}
      </h3>
      <ul className={styles["grid"]}>
        {missions.map((mission) => (
          <Beginning
            key={mission.id}
            name={t(`missions:missions.${mission.id}.name`)}
            picture={mission.challenge.mazes.slice(0, 1).map((maze) => (
              <MazePicture key={mission.id} maze={maze} />
            ))}
            onChoose={() => onChoose(missionLesson(mission, i18n))}
          />
        ))}
      </ul>
    </section>
  );
}
