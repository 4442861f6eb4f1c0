/**
 * Goal reached and bumps, told in words once each to those who listen; the timeline, the stage and the
 * lines show them. Before a run it says, in the timeline's place, how to begin one.
 */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { classNames } from "../../ui/class-names.ts";
import { storyOf } from "./story.ts";
import styles from "./transport.module.css";

export function RunStory() {
  const { t } = useTranslation();
  const { run } = useServices();
  const moment = useStore(run, (state) => state.moment);
  const isFresh = useStore(run, ({ nowTick }) => nowTick === 0);
  const story = moment === null ? null : storyOf(moment);
  return (
    <output className={classNames(styles["story"], !isFresh && "visually-hidden")}>
      {story !== null && t(`shell.story.${story.kind}.${story.teller}`, { ...story })}
      {story === null && isFresh && t("shell.story.hint")}
    </output>
  );
}
