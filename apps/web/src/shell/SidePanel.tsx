/** The panel beside the stage: driver, program or remote, sensors and drive keys. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { CardDock } from "../features/cards/CardDock.tsx";
import { DriveFoot } from "../features/drive/DriveFoot.tsx";
import { DriverChoice } from "../features/drive/DriverChoice.tsx";
import type { HoldStore } from "../features/drive/hold-store.ts";
import { MissionPlace } from "../features/lessons/OpenChallenge.tsx";
import { ProgramEditor } from "../features/program-editor/ProgramEditor.tsx";
import { LazyRemotePanel } from "../features/remote/lazy-remote-panel.ts";
import { Deferred } from "../ui/Deferred.tsx";
import styles from "./side-panel.module.css";
import { useServices } from "../model/use-services.ts";

export function SidePanel({ hold }: { hold: HoldStore }) {
  const { t } = useTranslation();
  const { run } = useServices();
  const isRemote = useStore(run, ({ snapshot }) => snapshot?.driver === "remote");
  return (
    <aside className={styles["panel"]} aria-label={t("shell.panel")}>
      <Deferred until="early-panel">
        <div className={styles["who"]}>
          <DriverChoice />
        </div>
        {isRemote ? (
          <div className={styles["remote"]}>
            <CardDock />
            <MissionPlace isInviting={false} />
            <LazyRemotePanel />
          </div>
        ) : (
          <>
            <div className={styles["program"]}>
              <CardDock />
              <MissionPlace />
              <ProgramEditor />
            </div>
            <DriveFoot hold={hold} />
          </>
        )}
      </Deferred>
    </aside>
  );
}
