/** Reports where the robot is, its readings and the running line, as the key I does. */
import { MessageSquareText } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { describeRobot } from "../../model/speech/describe-later.ts";

export function DescribeButton({ className }: { className?: string | undefined }) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const singleKeys = useStore(services.screen, (state) => state.singleKeys);
  return (
    <IconButton
      label={t("speech.describe.button")}
      className={className}
      aria-keyshortcuts={singleKeys ? "I" : undefined}
      onClick={() => void describeRobot(services, i18n)}
    >
      <Icon of={MessageSquareText} />
    </IconButton>
  );
}
