/** The bar at the top: the mark, the maze, and what can be done with it. */
import { Ellipsis, Keyboard, RadioTower, Target } from "lucide-react";
import { useTranslation } from "react-i18next";
import { LazyFileMenuItems } from "../features/files/lazy-file-menu-items.ts";
import { LanguageButton } from "../features/language/LanguageButton.tsx";
import { LanguageSelect } from "../features/language/LanguageSelect.tsx";
import { LessonsButton } from "../features/lessons/LessonsButton.tsx";
import { PresetsButton } from "../features/presets/PresetsButton.tsx";
import { ShareButton } from "../features/share/ShareButton.tsx";
import { ThemeButton } from "../features/theme/ThemeButton.tsx";
import { ThemeChoice } from "../features/theme/ThemeChoice.tsx";
import { MazeMenu } from "../features/works/MazeMenu.tsx";
import { IconButton } from "../ui/Button.tsx";
import { Later } from "../ui/Later.tsx";
import { MenuItem, Popover, usePopover } from "../ui/Popover.tsx";
import { useMediaQuery } from "../ui/use-media-query.ts";
import styles from "./app.module.css";
import { Brand } from "./Brand.tsx";

interface TopBarProps {
  isPhone: boolean;
  onKeys: () => void;
  onRemote: () => void;
  onLessons: () => void;
}

export function TopBar({ isPhone, onKeys, onRemote, onLessons }: TopBarProps) {
  const { t } = useTranslation();
  // The maze's name needs the room first.
  const isNarrow = useMediaQuery("(max-width: 56.24em)");
  return (
    <header className={styles["bar"]}>
      <Brand />
      <Later>
        <MazeMenu />
        <div className={styles["barEnd"]}>
          {!isPhone && <PresetsButton />}
          {!isPhone && <LessonsButton />}
          <ShareButton />
          {isNarrow ? (
            <More isPhone={isPhone} onKeys={onKeys} onRemote={onRemote} onLessons={onLessons} />
          ) : (
            <div className={styles["barLast"]}>
              <IconButton label={t("shell.keys.title")} size="medium" onClick={onKeys}>
                <Keyboard aria-hidden="true" />
              </IconButton>
              <ThemeButton />
              <LanguageButton />
            </div>
          )}
        </div>
      </Later>
    </header>
  );
}

/** What a narrow bar has no room for; a phone's has no panel with "Who drives?" either. */
function More({ isPhone, onKeys, onRemote, onLessons }: TopBarProps) {
  const { t } = useTranslation();
  const menu = usePopover();
  return (
    <>
      <IconButton label={t("shell.more")} size="large" {...menu.trigger}>
        <Ellipsis aria-hidden="true" />
      </IconButton>
      <Popover {...menu.panel} label={t("shell.more")} align="end">
        {isPhone && (
          <>
            <MenuItem icon={<Target aria-hidden="true" />} onSelect={onLessons}>
              {t("lessons.lessons")}
            </MenuItem>
            <MenuItem icon={<RadioTower aria-hidden="true" />} onSelect={onRemote}>
              {t("drive.remote")}
            </MenuItem>
          </>
        )}
        <MenuItem icon={<Keyboard aria-hidden="true" />} onSelect={onKeys}>
          {t("shell.keys.title")}
        </MenuItem>
        <LazyFileMenuItems />
        <div className={styles["moreTheme"]}>
          <ThemeChoice />
        </div>
        <div className={styles["moreTheme"]}>
          <LanguageSelect />
        </div>
      </Popover>
    </>
  );
}
