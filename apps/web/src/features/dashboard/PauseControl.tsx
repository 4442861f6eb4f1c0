/** Pauses everyone for a chosen time, or ends the pause. */
import { Pause, Play } from "lucide";
import { useTranslation } from "react-i18next";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { clockText } from "./clock-text.ts";
import { useContent, useDashboard } from "./dashboard-context.ts";

const MINUTES = [1, 2, 5, 10, 30] as const;

export function PauseControl({ isSmall }: { isSmall: boolean }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const menu = usePopover();
  const leftMs = useDashboard(({ classroom, now }) => {
    const endsAt = classroom?.time.pauseEndsAt ?? null;
    return endsAt === null || endsAt <= now ? null : endsAt - now;
  });
  if (leftMs !== null) {
    const left = clockText(leftMs + 999);
    return (
      <Button
        kind="primary"
        icon={<Icon of={Play} />}
        aria-label={t("pause.end")}
        onClick={() => void calls.resume().then(report)}
      >
        {isSmall ? left : t("pause.endLeft", { left })}
      </Button>
    );
  }
  return (
    <>
      {isSmall ? (
        <IconButton label={t("pause.start")} kind="outline" size="medium" {...menu.trigger}>
          <Icon of={Pause} />
        </IconButton>
      ) : (
        <Button icon={<Icon of={Pause} />} {...menu.trigger}>
          {t("pause.start")}
        </Button>
      )}
      <Popover {...menu.panel} label={t("pause.start")} align="end">
        {MINUTES.map((minutes) => (
          <MenuItem key={minutes} onSelect={() => void calls.pause(minutes * 60).then(report)}>
            {t("pause.minutes", { count: minutes })}
          </MenuItem>
        ))}
      </Popover>
    </>
  );
}
