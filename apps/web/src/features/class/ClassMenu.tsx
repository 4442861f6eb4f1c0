/**
 * The class in the bar: the student's name, which opens the menu, a hand while the student asks for
 * help, and an eye while the teacher watches.
 */
import { ChevronDown, Eye, Hand, School } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ClassWork } from "../../model/classes/class-work.ts";
import type { StudentClass } from "../../model/classes/student-class.ts";
import { studentNameText } from "../../model/classes/student-name.ts";
import { useAnnouncement } from "../../model/use-announcement.ts";
import { asSentence, joinSentences } from "../../text/joined.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { ClassMenuContent } from "./ClassMenuContent.tsx";
import { SurveyDialog } from "./SurveyDialog.tsx";
import styles from "./class-menu.module.css";

interface ClassMenuProps {
  joined: StudentClass;
  /** null before the page is ready for the lesson */
  work: ClassWork | null;
}

export function ClassMenu({ joined, work }: ClassMenuProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { t: tShared } = useTranslation();
  const { t: tNames } = useTranslation("names", { useSuspense: false });
  const isNarrow = useMediaQuery("(max-width: 74.99em)");
  const menu = usePopover();
  const { status, student } = useStore(joined.session);
  const name = studentNameText(tNames, student?.name ?? joined.name);
  const isWatched = status.kind === "connected" && student?.watched === true;
  const hasAsked = status.kind === "connected" && student?.helpWanted === true;
  const text = t("inClass.button", { name });
  const watched = isWatched ? t("inClass.watched") : null;
  const notes = [...(hasAsked ? [t("inClass.helpWanted")] : []), ...(watched ? [watched] : [])];
  useAnnouncement(watched, "class watched");
  return (
    <>
      <Button
        kind="quiet"
        className={styles["trigger"]}
        icon={
          isNarrow && hasAsked && !isWatched ? <Asked /> : <Icon of={isWatched ? Eye : School} />
        }
        aria-label={
          notes.length === 0 ? text : joinSentences(tShared, [asSentence(tShared, text), ...notes])
        }
        title={notes.length === 0 ? undefined : joinSentences(tShared, notes)}
        {...menu.trigger}
      >
        <span className={styles["name"]}>{isNarrow ? name : text}</span>
        {!isNarrow && hasAsked && <Asked text={t("inClass.asked")} />}
        <Icon of={ChevronDown} />
      </Button>
      <Popover {...menu.panel} label={t("inClass.menu")} align="end" className={styles["panel"]}>
        <ClassMenuContent joined={joined} work={work} />
      </Popover>
      {work !== null && <SurveyDialog work={work} />}
    </>
  );
}

/** The hand stands out, because a student waits. A narrow bar has no room for its words. */
function Asked({ text }: { text?: string }) {
  return (
    <span className={styles["asked"]}>
      <Icon of={Hand} size={14} />
      {text}
    </span>
  );
}
