/** Asks the teacher for help, in the card of the task, and states that the request has arrived. */
import { Hand } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { StudentClass } from "../../model/classes/student-class.ts";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./help-request.module.css";

interface HelpRequestProps {
  joined: StudentClass;
  /** `slim` is the hand alone, where the drive keys need the space; the bar states the request */
  look: "full" | "slim";
}

export function HelpRequest({ joined, look }: HelpRequestProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { status, student } = useStore(joined.session);
  if (status.kind !== "connected" || student === null) return null;
  const { helpWanted } = student;
  const label = t(helpWanted ? "inClass.helpOver" : "inClass.help");
  const press = () => joined.askForHelp(!helpWanted);
  if (look === "slim") {
    return (
      <IconButton label={label} kind={helpWanted ? "primary" : "outline"} onClick={press}>
        <Icon of={Hand} />
      </IconButton>
    );
  }
  return (
    <div className={styles["help"]}>
      <output className={styles["asked"]}>{helpWanted && t("inClass.helpWanted")}</output>
      <Button size="small" icon={<Icon of={Hand} size={16} />} onClick={press}>
        {label}
      </Button>
    </div>
  );
}
