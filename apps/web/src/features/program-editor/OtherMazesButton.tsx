/** The button below the lines of the program that opens "Try it in other mazes". */
import { LayoutGrid } from "lucide";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";

export function OtherMazesButton({ className }: { className?: string | undefined }) {
  const { t } = useTranslation();
  const { screen } = useServices();
  return (
    <Button
      kind="quiet"
      className={className}
      icon={<Icon of={LayoutGrid} />}
      onClick={() => screen.setState({ isTryingMazes: true })}
    >
      {t("program.otherMazes")}
    </Button>
  );
}
