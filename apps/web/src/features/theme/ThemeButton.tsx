/** The button of the theme in the top bar, which opens the choice. */
import { Contrast, Moon, Sun } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ScreenStore } from "../../model/screen/screen-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";

const ThemeChoice = lazyPart(async () => (await import("./ThemeChoice.tsx")).ThemeChoice);

const themeIcons = {
  system: <Icon of={Contrast} />,
  light: <Icon of={Sun} />,
  dark: <Icon of={Moon} />,
};

export function ThemeButton({ screen }: { screen: ScreenStore }) {
  const { t } = useTranslation();
  const theme = useStore(screen, (state) => state.theme);
  const menu = usePopover();
  return (
    <>
      <IconButton label={t("theme.label")} size="medium" {...menu.trigger}>
        {themeIcons[theme]}
      </IconButton>
      <Popover {...menu.panel} label={t("theme.label")} align="end">
        <ThemeChoice screen={screen} />
      </Popover>
    </>
  );
}
