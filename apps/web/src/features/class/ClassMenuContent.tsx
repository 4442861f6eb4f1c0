/** The class menu: help, another name, what the teacher sees, and the way out. */
import { Eye } from "lucide";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ClassWork } from "../../model/classes/class-work.ts";
import type { StudentClass } from "../../model/classes/student-class.ts";
import { studentNameText } from "../../model/classes/student-name.ts";
import type { ClassSession, ClassStudent } from "../../simulator/protocol/class-messages.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem } from "../../ui/Popover.tsx";
import styles from "./class-menu.module.css";

interface ClassProps {
  joined: StudentClass;
}

interface ContentProps extends ClassProps {
  /** null before the page is ready for the lesson */
  work: ClassWork | null;
}

export function ClassMenuContent({ joined, work }: ContentProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { t: tNames } = useTranslation("names", { useSuspense: false });
  const { status, student } = useStore(joined.session);
  const name = studentNameText(tNames, student?.name ?? joined.name);
  return (
    <div className={styles["content"]}>
      <output className={styles["you"]}>{t("inClass.youAre", { name })}</output>
      {status.kind === "connected" && student !== null ? (
        <StudentItems joined={joined} student={student} />
      ) : (
        <NotConnected joined={joined} status={status} />
      )}
      {work !== null && <LessonItems work={work} />}
      <details className={styles["more"]}>
        <summary>{t("teacherSees")}</summary>
        <p className={styles["text"]}>{t("teacherSeesText")}</p>
      </details>
      <Leave joined={joined} />
    </div>
  );
}

function StudentItems({ joined, student }: ClassProps & { student: ClassStudent }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { helpWanted, watched, rename, renamesLeft } = student;
  return (
    <>
      {watched && (
        <p className={styles["watched"]}>
          <Icon of={Eye} size={18} />
          {t("inClass.watched")}
        </p>
      )}
      <output className={styles["text"]}>{helpWanted && t("inClass.helpWanted")}</output>
      <Button
        kind={helpWanted ? "outline" : "primary"}
        onClick={() => joined.askForHelp(!helpWanted)}
      >
        {t(helpWanted ? "inClass.helpOver" : "inClass.help")}
      </Button>
      <MenuItem
        staysOpen
        disabled={renamesLeft === 0 || rename === "refused"}
        {...(rename === "refused" && { note: t("inClass.noOtherName") })}
        onSelect={() => {
          // A second press must not use up the next change, too.
          if (rename === "possible") joined.requestName();
        }}
      >
        {t("inClass.otherName", { left: renamesLeft })}
      </MenuItem>
    </>
  );
}

/** Also without a connection: the answers wait for it. */
function LessonItems({ work }: { work: ClassWork }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { document, isOpen } = useStore(work.lesson.state);
  const hasAnswered = useStore(work.survey, (state) => state.hasAnswered);
  if (document === null) return null;
  return (
    <>
      {!isOpen && (
        <MenuItem onSelect={() => void work.lesson.open()}>{t("inClass.lesson")}</MenuItem>
      )}
      {document.survey.length > 0 && !hasAnswered && (
        <MenuItem onSelect={() => work.openSurvey()}>{t("survey.title")}</MenuItem>
      )}
    </>
  );
}

function NotConnected({ joined, status }: ClassProps & Pick<ClassSession, "status">) {
  const { t } = useTranslation("join", { useSuspense: false });
  if (status.kind !== "over") {
    const text = status.kind === "lost" ? t("inClass.lost") : t("inClass.connecting");
    return <p className={styles["text"]}>{text}</p>;
  }
  return (
    <>
      <p className={styles["text"]}>{t("inClass.replaced")}</p>
      <Button kind="primary" onClick={() => joined.continueHere()}>
        {t("inClass.continueHere")}
      </Button>
    </>
  );
}

/** Asks first: a student who has left needs the letters again, and becomes another student. */
function Leave({ joined }: ClassProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  const [isAsking, setAsking] = useState(false);
  if (!isAsking) {
    return (
      <MenuItem staysOpen onSelect={() => setAsking(true)}>
        {t("inClass.leave")}
      </MenuItem>
    );
  }
  return <LeaveQuestion joined={joined} onStay={() => setAsking(false)} />;
}

function LeaveQuestion({ joined, onStay }: ClassProps & { onStay: () => void }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const stay = useRef<HTMLButtonElement>(null);
  // The item that opened the question is gone.
  useEffect(() => stay.current?.focus(), []);
  return (
    <fieldset className={styles["question"]}>
      <legend className={styles["text"]}>{t("inClass.leaveQuestion")}</legend>
      <div className={styles["actions"]}>
        <Button ref={stay} onClick={onStay}>
          {t("inClass.stay")}
        </Button>
        <Button kind="primary" onClick={() => joined.leave()}>
          {t("inClass.leave")}
        </Button>
      </div>
    </fieldset>
  );
}
