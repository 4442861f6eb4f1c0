/** Pauses everyone at once, or for a chosen time, and ends the pause. */
import { ChevronDown, Pause, Play } from "lucide";
import { useTranslation } from "react-i18next";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { classTimeText } from "./class-time-text.ts";
import { useContent, useDashboard } from "./dashboard-context.ts";
import styles from "./pause-control.module.css";

const MINUTES = [1, 2, 5, 10, 30] as const;
/** Long enough for an explanation. The clock ends a pause that the teacher does not end. */
const DEFAULT_MINUTES = 5;

export function PauseControl({ isSmall }: { isSmall: boolean }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const menu = usePopover();
  const leftMs = useDashboard(({ classroom, now }) => {
    const endsAt = classroom?.time.pauseEndsAt ?? null;
    return endsAt === null || endsAt <= now ? null : endsAt - now;
  });
  const pause = (minutes: number) => void calls.pause(minutes * 60).then(report);
  return (
    <div className={styles["control"]}>
      {leftMs === null ? (
        <PauseButton isSmall={isSmall} onPause={() => pause(DEFAULT_MINUTES)} />
      ) : (
        <Button
          kind="primary"
          icon={<Icon of={Play} />}
          aria-label={t("pause.end")}
          onClick={() => void calls.resume().then(report)}
        >
          {isSmall
            ? classTimeText(leftMs + 999)
            : t("pause.endLeft", { left: classTimeText(leftMs + 999) })}
        </Button>
      )}
      <IconButton
        label={t("pause.length")}
        kind="outline"
        size="medium"
        className={styles["more"]}
        {...menu.trigger}
      >
        <Icon of={ChevronDown} />
      </IconButton>
      <Popover {...menu.panel} label={t("pause.heading")} align="end">
        <h2 className={styles["heading"]}>{t("pause.heading")}</h2>
        {MINUTES.map((minutes) => (
          <MenuItem key={minutes} onSelect={() => pause(minutes)}>
            {t("pause.minutes", { count: minutes })}
          </MenuItem>
        ))}
      </Popover>
    </div>
  );
}

function PauseButton({ isSmall, onPause }: { isSmall: boolean; onPause: () => void }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const label = t("pause.startFor", { minutes: DEFAULT_MINUTES });
  if (isSmall) {
    return (
      <IconButton label={label} kind="outline" size="medium" onClick={onPause}>
        <Icon of={Pause} />
      </IconButton>
    );
  }
  return (
    <Button icon={<Icon of={Pause} />} onClick={onPause}>
      {label}
    </Button>
  );
}
