/** The button below the lines of the program that opens "Try it in other mazes". */
import { LayoutGrid } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import { Button } from "../../ui/Button.tsx";

export function OtherMazesButton({ className }: { className?: string | undefined }) {
  const { t } = useTranslation();
  const { screen } = useServices();
  return (
    <Button
      kind="quiet"
      className={className}
      icon={<LayoutGrid aria-hidden="true" />}
      onClick={() => screen.setState({ isTryingMazes: true })}
    >
      {t("program.otherMazes")}
    </Button>
  );
}
