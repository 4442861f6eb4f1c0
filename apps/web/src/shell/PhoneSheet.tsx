/** The sheet of the phone: Drive, Program and Presets as tabs, with three positions. */
import type { Rights } from "@corridor/challenge";
import { LayoutGrid, List, User } from "lucide";
import { useEffect, useLayoutEffect, useRef, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { CardDock } from "../features/cards/CardDock.tsx";
import { LazyDriveTab } from "../features/drive/lazy-drive-tab.ts";
import type { HoldStore } from "../features/drive/hold-store.ts";
import { MissionPlace } from "../features/lessons/OpenChallenge.tsx";
import { hasNewHint } from "../model/challenge/challenge-store.ts";
import { useRights, useTool } from "../model/use-rights.ts";
import { LazyPresetsPanel } from "../features/presets/lazy-presets-panel.ts";
import { ProgramEditor } from "../features/program-editor/ProgramEditor.tsx";
import { Icon } from "../ui/Icon.tsx";
import { Deferred } from "../ui/Deferred.tsx";
import { Tabs } from "../ui/Tabs.tsx";
import styles from "./phone-sheet.module.css";
import { algorithms } from "./lazy-menus.tsx";
import { useServices } from "../model/use-services.ts";
import { sheetTabs, type SheetTab } from "../model/screen/screen-store.ts";
import { afterDrag, afterPress, type SheetPosition } from "./sheet.ts";

const icons: Readonly<Record<SheetTab, ReactNode>> = {
  drive: <Icon of={User} />,
  program: <Icon of={List} isDirectional />,
  presets: <Icon of={LayoutGrid} />,
};

function tabFor(rights: Rights | null): SheetTab {
  return rights?.drivers[0] === "me" ? "drive" : "program";
}

export function PhoneSheet({ hold }: { hold: HoldStore }) {
  const { t } = useTranslation();
  const { challenge, camera, cardDock, screen } = useServices();
  const rights = useRights();
  const isMission = rights !== null;
  // A mission opens in the tab where it is solved, whatever tab was open before.
  const chosenTab = useStore(screen, (state) => state.sheetTab);
  const hasPresets = useTool("presets");
  const tabs = sheetTabs.filter((each) =>
    each === "presets"
      ? hasPresets
      : each === "program" || rights?.drivers.includes("me") !== false,
  );
  const tab = tabs.find((each) => each === chosenTab) ?? tabFor(rights);
  const [chosen, setPosition] = useState<SheetPosition>("half");
  useEffect(
    () =>
      challenge.subscribe((next, before) => {
        const isSame =
          next.mission === null
            ? next.lesson === before.lesson && next.index === before.index
            : next.mission === before.mission;
        if (next.lesson === null) return;
        // A hint of the teacher must be readable.
        if (next.hints !== before.hints) setPosition((at) => (at === "closed" ? "half" : at));
        if (!isSame) screen.setState({ sheetTab: null });
      }),
    [challenge, screen],
  );
  // An explanation of the run must be readable: it opens the sheet, whose own position is restored
  // after it.
  const need = useStore(cardDock, (state) => state.need);
  const isOwn = need === null || chosen === "open";
  const position = isOwn ? chosen : "half";
  const isDriving = tab === "drive" && position !== "closed";
  const hasHint = useStore(challenge, hasNewHint);
  useLayoutEffect(() => {
    camera.setState({ isDriving });
    return () => camera.setState({ isDriving: false });
  }, [camera, isDriving]);
  return (
    <aside
      className={styles["sheet"]}
      data-position={isOwn ? chosen : need}
      data-driving={isDriving}
      data-mission={isMission}
      data-hint={hasHint}
      aria-label={t("shell.panel")}
    >
      <Deferred until="early-sheet">
        <GrabBar
          position={position}
          onChange={(next) => {
            cardDock.setState({ need: null });
            setPosition(next);
          }}
        />
        <Tabs
          label={t("shell.panel")}
          value={tab}
          tabs={tabs.map((each) => ({
            value: each,
            label: t(`shell.tabs.${each}`),
            icon: icons[each],
          }))}
          onChange={(next) => {
            screen.setState({ sheetTab: next });
            if (position === "closed") setPosition("half");
          }}
          panelClassName={styles["content"]}
        >
          <CardDock />
          {tab === "drive" && (
            <>
              {isMission && <MissionPlace look="slim" />}
              <LazyDriveTab hold={hold} />
            </>
          )}
          {tab === "program" && (
            <>
              <MissionPlace />
              <ProgramEditor />
            </>
          )}
          {tab === "presets" && (
            <>
              <MissionPlace look="hint" />
              <LazyPresetsPanel algorithms={algorithms} />
            </>
          )}
        </Tabs>
      </Deferred>
    </aside>
  );
}

interface GrabBarProps {
  position: SheetPosition;
  onChange: (position: SheetPosition) => void;
}

/**
 * A handle that is also a button: a press goes to the next position, a drag one step in its
 * direction.
 */
function GrabBar({ position, onChange }: GrabBarProps) {
  const { t } = useTranslation();
  const startY = useRef<number | null>(null);
  const wasDragged = useRef(false);
  return (
    <button
      type="button"
      className={styles["grab"]}
      aria-label={t(`shell.sheet.${position}`)}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        startY.current = event.clientY;
        wasDragged.current = false;
      }}
      onPointerUp={(event) => {
        if (startY.current === null) return;
        const next = afterDrag(position, event.clientY - startY.current);
        startY.current = null;
        wasDragged.current = next !== position;
        if (wasDragged.current) onChange(next);
      }}
      onPointerCancel={() => (startY.current = null)}
      onClick={() => {
        if (!wasDragged.current) onChange(afterPress(position));
        wasDragged.current = false;
      }}
    />
  );
}
