/** The list of keys, with the switches for those that work without Ctrl and for the spoken run. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Checkbox } from "../ui/Checkbox.tsx";
import { Dialog } from "../ui/Dialog.tsx";
import { Kbd } from "../ui/Kbd.tsx";
import styles from "./shortcuts-dialog.module.css";
import { capsOf } from "./key-caps.ts";
import { useServices } from "./services.ts";

/** Each row: its words, and the keys that do the same (see key-caps.ts). */
const rows = [
  ["speech.keys.tab", ["Tab", "Shift+Tab"]],
  ["shell.keys.drive", ["W", "A", "S", "D", "↑", "←", "↓", "→"]],
  ["shell.keys.stop", ["Space", "Esc"]],
  ["shell.keys.run", ["Ctrl+Enter"]],
  ["shell.keys.step", ["Ctrl+Shift+Enter"]],
  ["shell.keys.maze", ["↑", "←", "↓", "→", "Space", "Enter"]],
  ["speech.keys.mazeFar", ["Home", "End", "Page Up", "Page Down", "Ctrl+Home", "Ctrl+End"]],
  ["speech.keys.tape", ["Esc"]],
  ["runDetails:stageZoom.keys", ["+", "-", "0"]],
  ["shell.keys.line", ["Alt+↑", "Alt+↓", "Delete"]],
  ["shell.keys.timeline", ["←", "→", "Home", "End"]],
  ["speech.keys.timelineTick", ["Shift+←", "Shift+→"]],
  ["speech.keys.timelineFar", ["Page Down", "Page Up"]],
  ["runDetails:timelineZoom.keys", ["+", "-", "0"]],
  ["shell.keys.undo", ["Ctrl+Z"]],
  ["shell.keys.redo", ["Ctrl+Shift+Z"]],
  ["speech.keys.describe", ["I"]],
  ["shell.keys.close", ["Esc"]],
  ["shell.keys.help", ["?"]],
] as const;

export function ShortcutsDialog({ isOpen, onClose }: { isOpen: boolean; onClose: () => void }) {
  const { t } = useTranslation(["words", "runDetails"], { useSuspense: false });
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
            label={t("shell.keys.single")}
            note={t("shell.keys.singleNote")}
            checked={singleKeys}
            onChange={(isOn) => screen.setState({ singleKeys: isOn })}
          />
          <Checkbox
            label={t("speech.setting")}
            note={t("speech.settingNote")}
            checked={speakRun}
            onChange={(isOn) => screen.setState({ speakRun: isOn })}
          />
        </div>
      }
    >
      <dl className={styles["keys"]}>
        {rows.map(([row, keys]) => (
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
