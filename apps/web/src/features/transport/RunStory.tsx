/**
 * The newest bump or goal as text for screen readers. When it happens, features/speech announces
 * it, and the timeline, the stage and the lines display it. Before a run, a visible hint how to
 * start one, or who drives in a challenge that excludes the program.
 */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useWaited } from "../../model/use-waited.ts";
import { classNames } from "../../ui/class-names.ts";
import { useRights } from "../../model/use-rights.ts";
import { startHint } from "../../model/run/run-button.ts";
import { storyOf, storyText, type Story } from "../../model/run/story.ts";
import styles from "./transport.module.css";

export function RunStory() {
  const { t } = useTranslation();
  const { run } = useServices();
  const event = useStore(run, (state) => state.event);
  const waited = useWaited(event?.tick ?? 0);
  const isFresh = useStore(run, ({ nowTick }) => nowTick === 0);
  const hint = startHint(useRights());
  const story = event === null ? null : storyOf(event, waited);
  return (
    <p role="note" className={classNames(styles["story"], !isFresh && "visually-hidden")}>
      {story !== null && <StoryText story={story} />}
      {story === null && isFresh && t(`shell.story.${hint}`)}
    </p>
  );
}

function StoryText({ story }: { story: Story }) {
  const { t, i18n, ready } = useTranslation(["words", "runDetails"], { useSuspense: false });
  return ready && storyText(t, story, i18n.language);
}
