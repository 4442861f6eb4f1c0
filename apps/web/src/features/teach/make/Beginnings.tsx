/**
 * The beginnings of a lesson or of a further task: the teacher's maze, an empty one, a file, the study
 * of 2013, a link, or a copy of a mission.
 */
import type { LessonDocument } from "@corridor/challenge";
import { FolderOpen, SquareDashed } from "lucide";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { missions } from "../../../model/lessons/missions/missions.ts";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { firstMaze } from "../../../simulator/protocol/first-project.ts";
import { Button } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { chooseFiles } from "../../../ui/incoming-files.ts";
import { MazePicture } from "../../../ui/MazePicture.tsx";
import { TextField } from "../../../ui/TextField.tsx";
import { LessonProblemNote } from "../lessons/LessonProblemNote.tsx";
import { emptyTaskMaze, missionLesson, newLesson, newTask } from "../lessons/new-lesson.ts";
import { study2013, studyMissions } from "../lessons/study-2013.ts";
import { openMaze } from "./begin-lesson.ts";
import styles from "./make-lesson.module.css";
import type { Beginning as Begun } from "./use-beginning.ts";

interface BeginningsProps {
  /** localStorage */
  device: KeyValueStorage;
  /** name of a task in a maze */
  task: string;
  beginning: Begun;
  /** label of the button that opens the link */
  openLink: string;
  /** whether the study of 2013, a whole lesson, is one of the choices */
  hasStudy: boolean;
  /** whether the page takes files that are dropped on it */
  takesDrops: boolean;
  onBegin: (lesson: LessonDocument) => void;
}

export function Beginnings(props: BeginningsProps) {
  const { device, task, beginning, openLink, hasStudy, takesDrops, onBegin } = props;
  const { t } = useTranslation(["teach", "words"], { useSuspense: false });
  const [own] = useState(() => openMaze(device));
  // Without a project, the student's page opens this maze.
  const maze = own ?? { ...firstMaze, name: t("words:presets.long-way-round.title") };
  const { problem, isOpening, openText, openFiles } = beginning;
  return (
    <>
      {problem !== null && <LessonProblemNote problem={problem} />}
      <ul className={styles["beginnings"]}>
        <Beginning
          name={t("teach:make.open.name")}
          note={maze.name || t("teach:make.open.unnamed")}
          picture={<MazePicture maze={maze} />}
          onChoose={() => onBegin(newLesson(newTask(maze, task), maze.name))}
        />
        <Beginning
          name={t("teach:make.empty.name")}
          note={t("teach:make.empty.note")}
          picture={<Icon of={SquareDashed} />}
          onChoose={() =>
            onBegin(newLesson(newTask(emptyTaskMaze(t("teach:make.mazeName")), task), ""))
          }
        />
        <Beginning
          name={t("teach:make.file.name")}
          note={t(takesDrops ? "teach:make.file.note" : "teach:make.file.lesson")}
          picture={<Icon of={FolderOpen} />}
          onChoose={() => chooseFiles((files) => void openFiles(files))}
        />
        {hasStudy && <Study onChoose={onBegin} />}
      </ul>
      <LinkForm
        submit={openLink}
        isOpening={isOpening}
        isInvalid={problem !== null}
        onOpen={openText}
      />
      <Missions onChoose={onBegin} />
    </>
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
  /** label of its button */
  submit: string;
  isOpening: boolean;
  isInvalid: boolean;
  onOpen: (text: string) => Promise<void>;
}

function LinkForm({ submit, isOpening, isInvalid, onOpen }: LinkFormProps) {
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
        {submit}
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
