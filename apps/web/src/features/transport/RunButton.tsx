/** Run, Pause or Run from here, with one position and one width. */
import { Pause, Play } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { useRights } from "../../model/use-rights.ts";
import { isProgramRefused, runButton, startHint } from "../../model/run/run-button.ts";
import styles from "./transport.module.css";

export function RunButton() {
  const { t } = useTranslation();
  const { simulator, run } = useServices();
  const does = useStore(run, runButton);
  const isFault = useStore(run, ({ fault }) => fault !== null);
  // The playback of a recorded run can be paused in any case.
  const rights = useRights();
  const isRefused = isProgramRefused(rights) && does !== "pause";
  const isMe = useStore(run, ({ snapshot }) => snapshot?.driver === "me");
  const note = isRefused
    ? t(`shell.story.${startHint(rights)}`)
    : does === "run-here"
      ? t("timeline.runFromHereNote")
      : isMe && does === "run"
        ? t("shell.run.runProgram")
        : undefined;
  return (
    <Button
      kind={does === "pause" ? "primary" : "run"}
      size="large"
      className={styles["run"]}
      data-does={does}
      icon={
        does === "pause" ? (
          <Icon of={Pause} fill="currentColor" />
        ) : (
          <Icon of={Play} fill="currentColor" />
        )
      }
      disabled={isFault || isRefused}
      title={note}
      aria-keyshortcuts="Control+Enter"
      // Sends what the label says, although the robot may have stopped by itself meanwhile.
      onClick={() => simulator.send({ type: does })}
    >
      {does === "run-here" ? t("timeline.runFromHere") : t(`shell.run.${does}`)}
    </Button>
  );
}
