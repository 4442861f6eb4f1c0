/** Goal reached and bumps, told in words once each; the place of the timeline. */
import { Flag } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { classNames } from "../../ui/class-names.ts";
import { storyOf } from "./story.ts";
import styles from "./transport.module.css";

/** The mark of a bump, as on the stage. */
function Burst() {
  return (
    <svg width="18" height="18" viewBox="-9 -9 18 18" aria-hidden="true">
      <path
        d="M0-8 1.9-4.6 5.7-5.7 4.6-1.9 8 0 4.6 1.9 5.7 5.7 1.9 4.6 0 8-1.9 4.6-5.7 5.7-4.6 1.9-8 0-4.6-1.9-5.7-5.7-1.9-4.6z"
        fill="none"
        stroke="currentColor"
        strokeWidth="1.75"
        strokeLinejoin="round"
      />
    </svg>
  );
}

export function RunStory() {
  const { t } = useTranslation();
  const { run } = useServices();
  const moment = useStore(run, (state) => state.moment);
  const isFresh = useStore(run, ({ snapshot }) => (snapshot?.tick ?? 0) === 0);
  const story = moment === null ? null : storyOf(moment);
  return (
    <output className={classNames(styles["story"], story !== null && styles[story.kind])}>
      {story?.kind === "goal" && <Flag size={18} aria-hidden="true" />}
      {story?.kind === "bump" && <Burst />}
      {story !== null && (
        <span>{t(`shell.story.${story.kind}.${story.teller}`, { ...story })}</span>
      )}
      {story === null && isFresh && <span className={styles["hint"]}>{t("shell.story.hint")}</span>}
    </output>
  );
}
