/** Asks the teacher for help, in the card of the task, and states that the request has arrived. */
import { Hand } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { StudentClass } from "../../model/classes/student-class.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./help-request.module.css";

export function HelpRequest({ joined }: { joined: StudentClass }) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { status, student } = useStore(joined.session);
  if (status.kind !== "connected" || student === null) return null;
  const { helpWanted } = student;
  return (
    <div className={styles["help"]}>
      <output className={styles["asked"]}>{helpWanted && t("inClass.helpWanted")}</output>
      <Button
        size="small"
        icon={<Icon of={Hand} size={16} />}
        onClick={() => joined.askForHelp(!helpWanted)}
      >
        {t(helpWanted ? "inClass.helpOver" : "inClass.help")}
      </Button>
    </div>
  );
}
