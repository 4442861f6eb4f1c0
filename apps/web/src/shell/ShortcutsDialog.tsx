/**
 * The list of keys, with switches for single-key shortcuts and for spoken messages about the run.
 */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Checkbox } from "../ui/Checkbox.tsx";
import { Dialog } from "../ui/Dialog.tsx";
import { Kbd } from "../ui/Kbd.tsx";
import styles from "./shortcuts-dialog.module.css";
import { capsOf } from "./key-caps.ts";
import { useServices } from "../model/use-services.ts";

/** Each row: its label, and keys with the same function (see key-caps.ts). */
const rows = [
  ["runDetails:keys.tab", ["Tab", "Shift+Tab"]],
  ["runDetails:keys.drive", ["W", "A", "S", "D", "↑", "←", "↓", "→"]],
  ["runDetails:keys.stop", ["Space", "Esc"]],
  ["runDetails:keys.run", ["Ctrl+Enter"]],
  ["runDetails:keys.step", ["Ctrl+Shift+Enter"]],
  ["runDetails:keys.maze", ["↑", "←", "↓", "→", "Space", "Enter"]],
  ["runDetails:keys.mazeFar", ["Home", "End", "Page Up", "Page Down", "Ctrl+Home", "Ctrl+End"]],
  ["runDetails:keys.tape", ["Esc"]],
  ["runDetails:stageZoom.keys", ["+", "-", "0"]],
  ["runDetails:keys.line", ["Alt+↑", "Alt+↓", "Delete"]],
  ["runDetails:keys.timeline", ["←", "→", "Home", "End"]],
  ["runDetails:keys.timelineTick", ["Shift+←", "Shift+→"]],
  ["runDetails:keys.timelineFar", ["Page Down", "Page Up"]],
  ["runDetails:timelineZoom.keys", ["+", "-", "0"]],
  ["runDetails:keys.undo", ["Ctrl+Z"]],
  ["runDetails:keys.redo", ["Ctrl+Shift+Z"]],
  ["runDetails:keys.describe", ["I"]],
  ["runDetails:keys.close", ["Esc"]],
  ["runDetails:keys.help", ["?"]],
] as const;

export function ShortcutsDialog({ isOpen, onClose }: { isOpen: boolean; onClose: () => void }) {
  const { t, ready } = useTranslation(["words", "runDetails"], { useSuspense: false });
  const { screen } = useServices();
  const singleKeys = useStore(screen, (state) => state.singleKeys);
  const speakRun = useStore(screen, (state) => state.speakRun);
  const isMac = navigator.platform.startsWith("Mac");
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("shell.keys.title")}
      width="narrow"
      isText
      footer={
        <div className={styles["switches"]}>
          <Checkbox
            label={t("runDetails:keys.single")}
            note={t("runDetails:keys.singleNote")}
            checked={singleKeys}
            onChange={(isOn) => screen.setState({ singleKeys: isOn })}
          />
          <Checkbox
            label={t("runDetails:speech.setting")}
            note={t("runDetails:speech.settingNote")}
            checked={speakRun}
            onChange={(isOn) => screen.setState({ speakRun: isOn })}
          />
        </div>
      }
    >
      <dl className={styles["keys"]}>
        {(ready ? rows : []).map(([row, keys]) => (
          <div key={row} className={styles["row"]}>
            <dt>{t(row)}</dt>
            <dd>
              {keys.map((key) => (
                <Kbd key={key}>{capsOf(t, key, isMac)}</Kbd>
              ))}
            </dd>
          </div>
        ))}
      </dl>
    </Dialog>
  );
}
