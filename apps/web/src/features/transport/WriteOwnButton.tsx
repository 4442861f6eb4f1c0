/** "Write my own" beside Run, while the program is the example and no script drives. */
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { Button } from "../../ui/Button.tsx";
import { useRights } from "../../model/use-rights.ts";
import { isExample } from "../../model/workspace/example.ts";

/** Selector of the first action in an empty program. */
const ADD_LINE = "#add-line";

export function WriteOwnButton({ className }: { className?: string | undefined }) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const rights = useRights();
  const isOpen = useStore(services.workspace, ({ program }) => isExample(program));
  const isRemote = useStore(services.run, ({ snapshot }) => snapshot?.driver === "remote");
  if (!isOpen || isRemote || rights !== null) return null;

  async function begin(): Promise<void> {
    try {
      const { writeOwn } = await import("./write-own.ts");
      writeOwn(services, i18n);
    } catch {
      showMessage(services.screen, { tone: "bad", text: t("offline.partFailed") });
      return;
    }
    // On a phone the goal stays in sight above the button.
    document.querySelector<HTMLElement>(ADD_LINE)?.focus({ preventScroll: true });
  }

  return (
    <Button size="large" className={className} onClick={() => void begin()}>
      {t("program.writeOwn")}
    </Button>
  );
}
