/** The list of keys, with the switch for those that work without Ctrl. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Checkbox } from "../ui/Checkbox.tsx";
import { Dialog } from "../ui/Dialog.tsx";
import { Kbd } from "../ui/Kbd.tsx";
import styles from "./app.module.css";
import { useServices } from "./services.ts";

/** Each row: its words, and the keys that do the same. A plus inside joins keys pressed together. */
const rows = [
  ["drive", ["W", "A", "S", "D", "↑", "←", "↓", "→"]],
  ["stop", ["Space", "Esc"]],
  ["run", ["Ctrl+Enter"]],
  ["step", ["Ctrl+Shift+Enter"]],
  ["timeline", ["←", "→", "Home", "End"]],
  ["undo", ["Ctrl+Z"]],
  ["redo", ["Ctrl+Shift+Z"]],
  ["maze", ["↑", "←", "↓", "→", "Space", "Enter"]],
  ["line", ["Alt+↑", "Alt+↓", "Delete"]],
  ["close", ["Esc"]],
  ["help", ["?"]],
] as const;

export function ShortcutsDialog({ isOpen, onClose }: { isOpen: boolean; onClose: () => void }) {
  const { t } = useTranslation();
  const { screen } = useServices();
  const singleKeys = useStore(screen, (state) => state.singleKeys);
  const isMac = navigator.platform.startsWith("Mac");
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("shell.keys.title")}
      width="narrow"
      footer={
        <Checkbox
          label={t("shell.keys.single")}
          note={t("shell.keys.singleNote")}
          checked={singleKeys}
          onChange={(isOn) => screen.setState({ singleKeys: isOn })}
        />
      }
    >
      <dl className={styles["keys"]}>
        {rows.map(([row, keys]) => (
          <div key={row} className={styles["keyRow"]}>
            <dt>{t(`shell.keys.${row}`)}</dt>
            <dd>
              {keys.map((key) => (
                <Kbd key={key}>{isMac ? key.replace("Ctrl", "⌘") : key}</Kbd>
              ))}
            </dd>
          </div>
        ))}
      </dl>
    </Dialog>
  );
}
