/** Opens the dialog that prints. */
import { Printer } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../Button.tsx";
import { Icon } from "../Icon.tsx";
import { PrintDialog } from "./lazy-print-dialog.ts";
import type { PrintedContent } from "./printed-content.ts";

interface PrintButtonProps {
  content: PrintedContent;
  size?: "small" | "medium";
}

export function PrintButton({ content, size = "medium" }: PrintButtonProps) {
  const { t, ready } = useTranslation("print", { useSuspense: false });
  const [isOpen, setOpen] = useState(false);
  if (!ready) return null;
  return (
    <>
      <Button size={size} icon={<Icon of={Printer} />} onClick={() => setOpen(true)}>
        {t("print")}
      </Button>
      <PrintDialog isOpen={isOpen} onClose={() => setOpen(false)} content={content} />
    </>
  );
}
