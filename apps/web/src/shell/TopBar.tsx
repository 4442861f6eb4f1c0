/** The bar at the top: logo, maze, and actions. */
import { Ellipsis, Keyboard } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { LessonsButton } from "../features/lessons/LessonsButton.tsx";
import { PresetsButton } from "../features/presets/PresetsButton.tsx";
import { ShareButton } from "../features/share/ShareButton.tsx";
import { MazeMenu } from "../features/projects/MazeMenu.tsx";
import { Icon } from "../ui/Icon.tsx";
import { IconButton } from "../ui/Button.tsx";
import { lazyPart } from "../ui/lazy-part.tsx";
import { Deferred } from "../ui/Deferred.tsx";
import { Popover, usePopover } from "../ui/Popover.tsx";
import { useMediaQuery } from "../ui/use-media-query.ts";
import styles from "./top-bar.module.css";
import { Brand } from "../ui/Brand.tsx";
import type { TopBarProps } from "./MoreMenu.tsx";
import { PageTools } from "./PageTools.tsx";
import { algorithms, FileItems } from "./lazy-menus.tsx";
import { useTool } from "../model/use-rights.ts";
import { useServices } from "../model/use-services.ts";

const MoreMenu = lazyPart(async () => (await import("./MoreMenu.tsx")).MoreMenu);

export function TopBar({ isPhone, onKeys, onRemote, onLessons }: TopBarProps) {
  const { t } = useTranslation();
  const { screen, classes } = useServices();
  const { shown: inClass, pauseEndsAt } = useStore(classes);
  // During a pause, only the class menu works.
  const work = { className: styles["work"], inert: pauseEndsAt !== null };
  // The maze's name needs the room first.
  const isNarrow = useMediaQuery("(max-width: 56.24em)");
  const hasPresets = useTool("presets");
  const hasShare = useTool("share");
  return (
    <header className={styles["bar"]}>
      <Brand />
      <Deferred>
        <div {...work}>
          <MazeMenu files={<FileItems />} />
        </div>
        <div className={styles["end"]}>
          <div {...work}>
            {!isPhone && hasPresets && <PresetsButton algorithms={algorithms} />}
            {!isPhone && <LessonsButton />}
            {hasShare && <ShareButton />}
          </div>
          {inClass !== null && <inClass.Menu joined={inClass.joined} />}
          <div {...work}>
            {isNarrow ? (
              <More isPhone={isPhone} onKeys={onKeys} onRemote={onRemote} onLessons={onLessons} />
            ) : (
              <div className={styles["last"]}>
                <IconButton label={t("shell.keys.title")} size="medium" onClick={onKeys}>
                  <Icon of={Keyboard} />
                </IconButton>
                <PageTools screen={screen} />
              </div>
            )}
          </div>
        </div>
      </Deferred>
    </header>
  );
}

/**
 * Items that do not fit into a narrow bar. On a phone, they include Remote, which has no panel
 * there.
 */
function More({ isPhone, onKeys, onRemote, onLessons }: TopBarProps) {
  const { t } = useTranslation();
  const menu = usePopover();
  return (
    <>
      <IconButton label={t("shell.more")} size="large" {...menu.trigger}>
        <Icon of={Ellipsis} />
      </IconButton>
      <Popover {...menu.panel} label={t("shell.more")} align="end">
        <MoreMenu isPhone={isPhone} onKeys={onKeys} onRemote={onRemote} onLessons={onLessons} />
      </Popover>
    </>
  );
}
