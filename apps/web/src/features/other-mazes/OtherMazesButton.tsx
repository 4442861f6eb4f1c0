/** Opens "Try it in other mazes" below the lines of the program. */
import { LayoutGrid } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { lazyDialog } from "../../ui/lazy-part.tsx";

const OtherMazesDialog = lazyDialog(
  async () => (await import("./OtherMazesDialog.tsx")).OtherMazesDialog,
);

export function OtherMazesButton({ className }: { className?: string | undefined }) {
  const { t } = useTranslation();
  const [isOpen, setOpen] = useState(false);
  return (
    <>
      <Button
        kind="quiet"
        className={className}
        icon={<LayoutGrid aria-hidden="true" />}
        onClick={() => setOpen(true)}
      >
        {t("program.otherMazes")}
      </Button>
      <OtherMazesDialog isOpen={isOpen} onClose={() => setOpen(false)} />
    </>
  );
}
