/** Opens files that the user drops or pastes anywhere on the page. Menus use `useFileActions`. */
import { FileDown } from "lucide";
import { useCallback, useEffect, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { chooseFiles, listenForFiles, type TextFile } from "../../ui/incoming-files.ts";
import { lazyDialog } from "../../ui/lazy-part.tsx";
import { FileActionsProvider } from "./file-actions.ts";
import type { FileReport } from "./open-files.ts";
import styles from "./files.module.css";

const FileProblems = lazyDialog(async () => (await import("./FileProblems.tsx")).FileProblems);
const ContestDialog = lazyDialog(
  async () => (await import("./contest/ContestDialog.tsx")).ContestDialog,
);
const PictureDialog = lazyDialog(async () => (await import("./PictureDialog.tsx")).PictureDialog);

export function FileDropTarget({ children }: { children: ReactNode }) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const [reports, setReports] = useState<readonly FileReport[]>([]);
  const [isOver, setIsOver] = useState(false);
  const [saving, setSaving] = useState<"picture" | "contest" | null>(null);

  const take = useCallback(
    async (files: readonly TextFile[]): Promise<void> => {
      try {
        const { openFiles } = await import("./open-files.ts");
        setReports(await openFiles(services, i18n, files));
      } catch {
        showMessage(services.screen, { tone: "bad", text: i18n.t("offline.partFailed") });
      }
    },
    [services, i18n],
  );

  const paste = useCallback(
    async (text: string): Promise<void> => {
      try {
        const { openPasted } = await import("./open-pasted.ts");
        await openPasted(services, i18n, text, take);
      } catch {
        showMessage(services.screen, { tone: "bad", text: i18n.t("offline.partFailed") });
      }
    },
    [take, services, i18n],
  );

  useEffect(
    () =>
      listenForFiles({
        over: setIsOver,
        take: (files) => void take(files),
        pasted: (text) => void paste(text),
      }),
    [take, paste],
  );

  return (
    <FileActionsProvider
      value={{
        choose: () => chooseFiles((files) => void take(files)),
        savePicture: () => setSaving("picture"),
        saveContest: () => setSaving("contest"),
      }}
    >
      {children}
      {isOver && (
        <div className={styles["target"]}>
          <p className={styles["targetWords"]}>
            <Icon of={FileDown} />
            {t("files.drop")}
          </p>
        </div>
      )}
      <FileProblems isOpen={reports.length > 0} reports={reports} onClose={() => setReports([])} />
      <PictureDialog isOpen={saving === "picture"} onClose={() => setSaving(null)} />
      <ContestDialog isOpen={saving === "contest"} onClose={() => setSaving(null)} />
    </FileActionsProvider>
  );
}
