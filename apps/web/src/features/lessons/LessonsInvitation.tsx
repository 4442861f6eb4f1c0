/** Invitation to the first mission for a first-time visitor: one line at the top of the panel. */
import { X } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import styles from "./lessons-invitation.module.css";

const FIRST_MISSION = "make-it-move";

/** Renders nothing unless the student is invited. */
export function LessonsInvitation() {
  const { t } = useTranslation();
  const { challenge, lessons, workspace } = useServices();
  const isInvited = useStore(challenge, (state) => state.isInvited);
  // A program with more lines than the example is the student's own, and its lines need the space.
  const hasBegun = useStore(workspace, ({ program }) => program.rules.length > 2);
  if (!isInvited || hasBegun) return null;
  return (
    <section className={styles["invitation"]} aria-label={t("lessons.lessons")}>
      <p className={styles["words"]}>{t("lessons.invitation")}</p>
      <div className={styles["answers"]}>
        <Button
          size="small"
          kind="primary"
          className={styles["begin"]}
          onClick={() => void lessons.openMission(FIRST_MISSION)}
        >
          {t("lessons.begin")}
        </Button>
        <IconButton label={t("lessons.notNow")} onClick={() => lessons.dismissInvitation()}>
          <Icon of={X} />
        </IconButton>
      </div>
    </section>
  );
}
