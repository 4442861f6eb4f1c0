/** One student: live picture, program, attempts by failure, and how the teacher can help. */
import { KeyRound, Lightbulb, Monitor, UserX, X } from "lucide";
import { useEffect, useRef, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useShallow } from "zustand/react/shallow";
import { shownCode } from "../../model/classes/shown-code.ts";
import { MAX_NOTE } from "../../model/classroom/own-classes.ts";
import { activeNow, verificationOf } from "../../model/classroom/dashboard.ts";
import { needsHelp, openTask, openWork } from "../../model/classroom/standing.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { directionOf } from "../../text/direction.ts";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { TextField } from "../../ui/TextField.tsx";
import { classTimeText } from "./class-time-text.ts";
import { useContent, useDashboard, useStudentName } from "./dashboard-context.ts";
import { ProgramText } from "./ProgramText.tsx";
import { StandingChip } from "./StandingChip.tsx";
import { PictureArea, StudentPicture } from "./StudentPicture.tsx";
import { cardFacts, cardSeconds, cardState } from "./use-card.ts";
import { WatchedAttempts } from "./WatchedAttempts.tsx";
import styles from "./watch-sheet.module.css";

interface WatchSheetProps {
  /** number of the student */
  student: number;
  /** whether the run of the student is on the big screens */
  isOnScreens: boolean;
  onScreens: (isShown: boolean) => void;
  onClose: () => void;
}

export function WatchSheet(props: WatchSheetProps) {
  const { student: number, isOnScreens, onScreens, onClose } = props;
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard } = useContent();
  const student = useDashboard(({ students }) => students.get(number));
  const sheet = useRef<HTMLElement>(null);
  const isGone = student === undefined;
  useEffect(() => {
    dashboard.send({ type: "watch", student: number });
    dashboard.countSeconds(true);
    sheet.current?.focus();
    return () => {
      dashboard.send({ type: "watch", student: null });
      dashboard.countSeconds(false);
      document.querySelector<HTMLElement>(`[data-student="${number}"]`)?.focus();
    };
  }, [dashboard, number]);
  useEffect(() => {
    if (isGone) onClose();
  }, [isGone, onClose]);
  if (student === undefined) return null;
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions -- Escape closes it
    <aside
      ref={sheet}
      className={styles["sheet"]}
      tabIndex={-1}
      aria-labelledby="watched-student"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        onClose();
      }}
    >
      <SheetHead student={student} onClose={onClose} />
      <Facts student={student} />
      <PictureArea className={styles["stage"]}>
        <StudentPicture student={number} />
      </PictureArea>
      <Unverified student={student} />
      <ProgramText student={student} />
      <WatchedAttempts student={student} />
      <Actions student={student} label={t("watch.actions")}>
        <Button icon={<Icon of={Monitor} />} onClick={() => onScreens(!isOnScreens)}>
          {isOnScreens ? t("screen.hide") : t("screen.show")}
        </Button>
      </Actions>
      <TeacherNote student={student} />
    </aside>
  );
}

function SheetHead({ student, onClose }: { student: SeenStudent; onClose: () => void }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const nameOf = useStudentName();
  const state = useDashboard((all) => cardState(all, student));
  const urgentSeconds = useDashboard((all) => {
    const shown = all.shown.get(student.student);
    if (shown === undefined || !needsHelp(shown.standing)) return null;
    return Math.floor((activeNow(all) - shown.since) / 1_000);
  });
  return (
    <div className={styles["head"]}>
      <h2 id="watched-student" className={styles["name"]} dir="auto">
        {nameOf(student)}
      </h2>
      {/* The sheet has its own sentence for it. */}
      {state !== "unverified" && <StandingChip state={state} />}
      {urgentSeconds !== null && (
        <span className={styles["time"]}>
          {t("watch.since", { time: classTimeText(urgentSeconds * 1_000) })}
        </span>
      )}
      <IconButton label={t("close")} size="medium" onClick={onClose}>
        <Icon of={X} />
      </IconButton>
    </div>
  );
}

/** The task, the time on it, and the size of the program. */
function Facts({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const facts = useDashboard(useShallow((all) => cardFacts(all, student.student)));
  const seconds = useDashboard((all) => cardSeconds(all, student.student));
  if (facts === null) return null;
  return (
    <p className={styles["facts"]}>
      {facts.hasTasks && <span>{t("card.task", { task: facts.task })}</span>}
      <span>
        {t("watch.onTask")} <strong>{classTimeText(seconds * 1_000)}</strong>
      </span>
      {facts.lines !== null && <span>{t("card.lines", { count: facts.lines })}</span>}
    </p>
  );
}

/** A note such as who Juniper is. It is hidden with the names, because it may have another one. */
function TeacherNote({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { notes, hidesNames } = useContent();
  const nameOf = useStudentName();
  const { student: number } = student;
  const [text, setText] = useState(() => notes.read(number));
  if (hidesNames) return null;
  return (
    <TextField
      label={t("watch.note", { name: nameOf(student) })}
      note={t("watch.noteStays")}
      value={text}
      maxLength={MAX_NOTE}
      dir="auto"
      onChange={(next) => {
        setText(next);
        notes.write(number, next.trim());
      }}
    />
  );
}

function Unverified({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const isUnverified = useDashboard((all) => verificationOf(all, student)?.kind === "fails");
  return isUnverified && <p className={styles["wrong"]}>{t("watch.unverified")}</p>;
}

/** What the student will read, before the teacher shows it. */
function NextHint({ hint, text }: { hint: number; text: string }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const language = useDashboard(({ lesson }) => lesson?.language ?? null);
  return (
    <p id="next-hint" className={styles["hint"]}>
      <strong>{t("watch.hintNext", { hint })}</strong>{" "}
      <span lang={language ?? undefined} dir={directionOf(language)}>
        {text}
      </span>
    </p>
  );
}

interface ActionsProps {
  student: SeenStudent;
  label: string;
  /** more buttons */
  children: ReactNode;
}

function Actions({ student, label, children }: ActionsProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard, calls, report } = useContent();
  const nameOf = useStudentName();
  const task = openTask(student);
  // Who has solved the task needs no hint.
  const hints = useDashboard((all) =>
    verificationOf(all, student)?.kind === "passes"
      ? undefined
      : all.lesson?.tasks[task - 1]?.words.hints,
  );
  const [shown, setShown] = useState<ReadonlyMap<number, number>>(new Map());
  const [code, setCode] = useState<string | null>(null);
  const [isRemoving, setRemoving] = useState(false);
  const count = hints?.length ?? 0;
  const seen = Math.max(openWork(student)?.hints ?? 0, shown.get(task) ?? 0);
  const next = Math.min(count, seen + 1);
  const showHint = (): void => {
    dashboard.send({ type: "hint", student: student.student, task, hint: next });
    setShown(new Map(shown).set(task, next));
  };
  const returnCode = async (): Promise<void> => {
    const found = await calls.returnCode(student.student);
    if (found === null) report("offline");
    else setCode(found.code);
  };
  return (
    <section className={styles["part"]} aria-label={label}>
      {count > 0 && <NextHint hint={next} text={hints?.[next - 1] ?? ""} />}
      <div className={styles["actions"]}>
        {count > 0 && (
          <Button
            icon={<Icon of={Lightbulb} />}
            disabled={!student.isConnected}
            aria-describedby="next-hint"
            onClick={showHint}
          >
            {t(seen < count ? "watch.hint" : "watch.hintAgain", { hint: next })}
          </Button>
        )}
        {children}
        <Button icon={<Icon of={KeyRound} />} onClick={() => void returnCode()}>
          {t("watch.return")}
        </Button>
        <Button icon={<Icon of={UserX} />} onClick={() => setRemoving(!isRemoving)}>
          {t("watch.remove")}
        </Button>
      </div>
      <output className={styles["said"]}>
        {count > 0 && (shown.get(task) ?? 0) > 0 && (
          <p>{t("watch.hintShown", { hint: shown.get(task) })}</p>
        )}
        {code !== null && (
          <p>
            {t("watch.returnText")}{" "}
            <strong className={styles["letters"]} dir="ltr">
              {shownCode(code)}
            </strong>
          </p>
        )}
      </output>
      {isRemoving && (
        <div className={styles["question"]}>
          <p>{t("watch.removeText", { name: nameOf(student) })}</p>
          <Button kind="primary" onClick={() => void calls.remove(student.student).then(report)}>
            {t("watch.remove")}
          </Button>
        </div>
      )}
    </section>
  );
}
