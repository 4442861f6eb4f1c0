/** Opens "Try it in other mazes" below the lines of the program. */
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
