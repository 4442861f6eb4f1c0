/** Full screen for the maze and its program, where the browser supports it. */
import { Maximize, Minimize } from "lucide";
import { useSyncExternalStore } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import styles from "./tool-strip.module.css";

export function FullScreenButton() {
  const { screen } = useServices();
  const { t } = useTranslation();
  const isFull = useSyncExternalStore(observeFullScreen, () => document.fullscreenElement !== null);
  if (!document.fullscreenEnabled) return null;

  function toggle(): void {
    const done = isFull ? document.exitFullscreen() : document.documentElement.requestFullscreen();
    // The browser can reject the request, depending on its settings.
    done.catch(() => showMessage(screen, { tone: "info", text: t("stage.fullScreenRefused") }));
  }

  return (
    <IconButton
      label={t(isFull ? "stage.leaveFullScreen" : "stage.fullScreen")}
      className={styles["fullScreen"]}
      onClick={toggle}
    >
      {isFull ? <Icon of={Minimize} /> : <Icon of={Maximize} />}
    </IconButton>
  );
}

function observeFullScreen(onChange: () => void): () => void {
  document.addEventListener("fullscreenchange", onChange);
  return () => document.removeEventListener("fullscreenchange", onChange);
}
