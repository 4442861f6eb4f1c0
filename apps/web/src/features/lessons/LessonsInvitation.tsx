/** For a reader who has never been here: one calm line at the top of the panel. */
import { X } from "lucide-react";
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { Button, IconButton } from "../../ui/Button.tsx";
import { isExample } from "../program/example.ts";
import styles from "./lessons-invitation.module.css";

const FIRST_MISSION = "make-it-move";

/** Shows nothing to others. */
export function LessonsInvitation() {
  const { t } = useTranslation();
  const { challenge, lessons, workspace, run } = useServices();
  const isInvited = useStore(challenge, (state) => state.isInvited);
  // A student who runs their own lines has begun, and the lines need the room.
  const isOwn = useStore(
    workspace,
    ({ program }) => program.rules.length > 0 && !isExample(program),
  );
  const hasBegun = useStore(run, ({ nowTick }) => nowTick > 0) && isOwn;
  useEffect(() => {
    if (hasBegun) challenge.setState({ isInvited: false });
  }, [challenge, hasBegun]);
  if (!isInvited) return null;
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
          <X aria-hidden="true" />
        </IconButton>
      </div>
    </section>
  );
}
