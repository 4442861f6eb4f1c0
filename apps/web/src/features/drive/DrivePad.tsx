/** The drive keys on the screen, drawn as keys of a keyboard: hold one to drive. */
import { ArrowDown, ArrowUp, CornerUpLeft, CornerUpRight, Square } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Icon } from "../../ui/Icon.tsx";
import { classNames } from "../../ui/class-names.ts";
import type { DriveKey } from "../../simulator/protocol/worker-messages.ts";
import styles from "./drive-pad.module.css";
import { activeKey, isHeldBy, type HoldStore } from "./hold-store.ts";

/** Without a cap: the space bar, whose name depends on the language. */
const keys: readonly { key: DriveKey; cap: string | null; icon: ReactNode }[] = [
  { key: "forward", cap: "W", icon: <Icon of={ArrowUp} /> },
  { key: "left", cap: "A", icon: <Icon of={CornerUpLeft} /> },
  { key: "stop", cap: null, icon: <Icon of={Square} fill="currentColor" /> },
  { key: "right", cap: "D", icon: <Icon of={CornerUpRight} /> },
  { key: "reverse", cap: "S", icon: <Icon of={ArrowDown} /> },
];

/** @param caps keyboard: W A S D on the keys; words: forward, left, stop, right, reverse */
export function DrivePad({ hold, caps }: { hold: HoldStore; caps: "keyboard" | "words" }) {
  const { t } = useTranslation();
  const active = useStore(hold, activeKey);
  return (
    <fieldset
      aria-label={t("drive.hold")}
      className={classNames(styles["pad"], caps === "words" && styles["big"])}
    >
      {keys.map(({ key, cap, icon }) => (
        <button
          key={key}
          type="button"
          className={classNames(styles["key"], styles[key])}
          aria-label={t(`drive.key.${key}`)}
          aria-pressed={active === key}
          {...holdHandlers(hold, key)}
        >
          {icon}
          <span aria-hidden="true">
            {caps === "words" ? t(`drive.key.${key}`) : (cap ?? t("drive.cap.space"))}
          </span>
        </button>
      ))}
    </fieldset>
  );
}

/**
 * Presses on down, and releases on up or lost capture: for pointers, Space and Enter, and voice
 * control.
 */
function holdHandlers(hold: HoldStore, key: DriveKey) {
  const byKeyboard = `button ${key}`;
  const byClick = `click ${key}`;
  const release = (event: React.PointerEvent) => hold.release(`pointer ${event.pointerId}`);
  const isPressKey = (event: React.KeyboardEvent) => event.key === " " || event.key === "Enter";
  return {
    onPointerDown: (event: React.PointerEvent<HTMLElement>) => {
      if (event.button !== 0) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      hold.press(`pointer ${event.pointerId}`, key);
    },
    onPointerUp: release,
    onPointerCancel: release,
    onLostPointerCapture: release,
    // A long touch must not open a menu over the held key.
    onContextMenu: (event: React.MouseEvent) => event.preventDefault(),
    onKeyDown: (event: React.KeyboardEvent) => {
      if (!isPressKey(event) || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      hold.press(byKeyboard, key);
    },
    onKeyUp: (event: React.KeyboardEvent) => {
      if (!isPressKey(event)) return;
      event.preventDefault();
      hold.release(byKeyboard);
    },
    onBlur: () => hold.release(byKeyboard),
    // A click without a pointer or a key (voice control, a screen reader) cannot be held: the first
    // click presses, the second releases.
    onClick: (event: React.MouseEvent) => {
      if (event.detail !== 0) return;
      const isHeld = isHeldBy(hold.getState(), byClick);
      hold.release(byClick);
      if (!isHeld) hold.press(byClick, key);
    },
  };
}
