/**
 * Layout of the page: bar, stage, panel and transport; on phones bar, stage, transport and sheet.
 */
import "../ui/base.css";
import "../ui/fonts/inter.css";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { DriverChoice } from "../features/drive/DriverChoice.tsx";
import { LessonsDialog } from "../features/lessons/lazy-lessons-dialog.ts";
import { FileDropTarget } from "../features/files/FileDropTarget.tsx";
import { Messages } from "../features/messages/Messages.tsx";
import { LazyRemotePanel } from "../features/remote/lazy-remote-panel.ts";
import { PairingPlace } from "../features/remote/PairingPlace.tsx";
import { SpokenRun } from "../features/speech/SpokenRun.tsx";
import { Button } from "../ui/Button.tsx";
import { Dialog } from "../ui/Dialog.tsx";
import { Deferred } from "../ui/Deferred.tsx";
import { lazyDialog } from "../ui/lazy-part.tsx";
import { useMediaQuery } from "../ui/use-media-query.ts";
import styles from "./app.module.css";
import { LoadingPage } from "./LoadingPage.tsx";
import { ErrorBoundary } from "../ui/ErrorBoundary.tsx";
import { lazyRestoreFocus } from "./lazy-restore-focus.ts";
import { PhoneSheet } from "./PhoneSheet.tsx";
import { useServices } from "../model/use-services.ts";
import { RunControls } from "./RunControls.tsx";
import { StageArea } from "./StageArea.tsx";
import { SidePanel } from "./SidePanel.tsx";
import { TopBar } from "./TopBar.tsx";
import { useKeyboard } from "./use-keyboard.ts";

const OtherMazesDialog = lazyDialog(
  async () => (await import("../features/other-mazes/OtherMazesDialog.tsx")).OtherMazesDialog,
);
const ShortcutsDialog = lazyDialog(
  async () => (await import("./ShortcutsDialog.tsx")).ShortcutsDialog,
);

export function App() {
  const { projects, screen } = useServices();
  const isOpening = useStore(screen, (state) => state.isOpening);
  return (
    <ErrorBoundary onError={() => projects.autosave.flush()}>
      <FileDropTarget>{isOpening ? <LoadingPage /> : <Page />}</FileDropTarget>
    </ErrorBoundary>
  );
}

/** The order of the regions is the tab order. The stage has the same position in every layout. */
function Page() {
  const { t } = useTranslation();
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  const [opened, setOpened] = useState<"keys" | "remote" | null>(null);
  const { camera, run, challenge, classes } = useServices();
  const { shown: inClass, pauseEndsAt } = useStore(classes);
  const isPathOpen = useStore(challenge, (state) => state.isPathOpen);
  const isDriving = useStore(camera, (state) => state.isDriving);
  const isNow = useStore(run, ({ view }) => view === "now");
  const hold = useKeyboard(() => setOpened("keys"));
  const close = () => setOpened(null);
  useEffect(lazyRestoreFocus, []);
  return (
    <div className={styles["page"]}>
      <TopBar
        isPhone={isPhone}
        onKeys={() => setOpened("keys")}
        onRemote={() => setOpened("remote")}
        onLessons={() => challenge.setState({ isPathOpen: true })}
      />
      {inClass !== null && pauseEndsAt !== null && <inClass.Band endsAt={pauseEndsAt} />}
      <div className={styles["work"]} inert={pauseEndsAt !== null}>
        <main className={styles["stage"]}>
          <Deferred>
            <StageArea />
          </Deferred>
          <FaultNotice />
          <Deferred>
            <Messages>
              <PairingPlace />
            </Messages>
          </Deferred>
        </main>
        {isPhone ? (
          <>
            {/* The Drive tab needs the room, but an earlier tick always needs a way back to the
              newest. */}
            {(!isDriving || !isNow) && (
              <div className={styles["footer"]}>
                <RunControls />
              </div>
            )}
            <PhoneSheet hold={hold} />
          </>
        ) : (
          <>
            <SidePanel hold={hold} />
            <div className={styles["footer"]}>
              <RunControls />
            </div>
          </>
        )}
      </div>
      <Deferred>
        <SpokenRun />
        <LessonsDialog
          isOpen={isPathOpen}
          onClose={() => challenge.setState({ isPathOpen: false })}
        />
        <OtherMazes />
        <ShortcutsDialog isOpen={opened === "keys"} onClose={close} />
        <Dialog isOpen={opened === "remote"} onClose={close} title={t("drive.remote")}>
          <div className={styles["remote"]}>
            <DriverChoice />
            <LazyRemotePanel />
          </div>
        </Dialog>
      </Deferred>
    </div>
  );
}

/** Opens and closes without rendering the page around it. */
function OtherMazes() {
  const { screen } = useServices();
  const isOpen = useStore(screen, (state) => state.isTryingMazes);
  return (
    <OtherMazesDialog isOpen={isOpen} onClose={() => screen.setState({ isTryingMazes: false })} />
  );
}

/**
 * Shown after the simulator stopped for good: the project is stored, and a reload starts a new
 * simulator.
 */
function FaultNotice() {
  const { t } = useTranslation();
  const { run } = useServices();
  const fault = useStore(run, (state) => state.fault);
  return (
    <div role="alert">
      {fault !== null && (
        <div className={styles["fault"]}>
          <p>{t("shell.failure.simulator", { reason: fault })}</p>
          <Button size="small" onClick={() => location.reload()}>
            {t("shell.failure.reload")}
          </Button>
        </div>
      )}
    </div>
  );
}
